// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/edit_transfer.h"

#include <QMimeData>

#include "core/io/json_text.h"

namespace gonio::app {

namespace {

const QString mimeType = QStringLiteral("application/x-gonio-edit+json");

double transferred(const models::ParameterSpec& spec, double from, double to, double fitted) {
  if (from == to) return fitted;
  if (!spec.choices.empty() || from == fitted) return to;
  if (spec.scale == models::ParameterScale::logarithmic && from > 0) return fitted * (to / from);
  return fitted + (to - from);
}

}  // namespace

models::ParameterValues transferredEdit(const editing::DifferentialEdit& edit, const models::ParameterValues& fitted) {
  const models::ModelSpec& spec = edit.model->spec();
  models::ParameterValues result = fitted;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i)
    for (int c = 0; c < 3; ++c)
      result.values[i][c] =
          transferred(spec.parameters[i], edit.fitted.values[i][c], edit.edited.values[i][c], fitted.values[i][c]);
  models::clampToHardRange(spec, result);
  return result;
}

QMimeData* toClipboard(const editing::EditDocument& document) {
  const std::string text = io::jsonText(editing::toJson(document), 2);
  auto* data = new QMimeData;
  data->setData(mimeType, QByteArray::fromStdString(text));
  data->setText(QString::fromStdString(text));
  return data;
}

editing::EditList editsFromClipboard(const QMimeData* data) {
  if (!data) return {};
  const QByteArray text = data->hasFormat(mimeType) ? data->data(mimeType) : data->text().toUtf8();
  try {
    editing::EditList edits = editing::documentFromText(text.toStdString()).edits;
    editing::EditList changes;
    for (const editing::Edit& edit : edits)
      if (!edit.isIdentity()) changes.push_back(edit);
    return changes.empty() ? edits : changes;
  } catch (const std::exception&) {
    // Some other text: nothing to paste.
  }
  return {};
}

}  // namespace gonio::app
