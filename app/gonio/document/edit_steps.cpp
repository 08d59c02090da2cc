// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/edit_steps.h"

#include <QCoreApplication>
#include <QMimeData>
#include <algorithm>

#include "core/editing/edit_list.h"
#include "core/io/json_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

using editing::DifferentialEdit;
using editing::Edit;
using editing::EditList;

struct EditStepText {
  Q_DECLARE_TR_FUNCTIONS(EditStep)
};

QString kindName(const DifferentialEdit& edit) { return widgets::toQString(edit.model->spec().name); }
QString kindName(const editing::FactorEdit&) { return EditStepText::tr("Factor curves"); }

QString plainName(const Edit& edit) {
  if (!edit.name.empty()) return QString::fromStdString(edit.name);
  return std::visit([](const auto& content) { return kindName(content); }, edit.content);
}

QString nameOf(const Document& document, int edit) { return editName(document.edits(), edit); }

const models::ParameterSpec& specOf(const DifferentialEdit& edit, int parameter) {
  return edit.model->spec().parameters[std::size_t(parameter)];
}

const models::ParameterSpec& specOf(editing::ArtistControl control) {
  return editing::artistControls().parameters[std::size_t(control)];
}

EditList withControl(const Document& document, int edit, editing::ArtistControl control, const Rgb& value) {
  return editing::withEdit(document.edits(), std::size_t(edit), [&](Edit& one) {
    std::get<DifferentialEdit>(one.content).controls.values[std::size_t(control)] = value;
  });
}

/// The text names what the whole interaction did, from its begin.
QString changeText(const Document& document, int edit, int parameter, const Rgb& value) {
  const auto at = std::size_t(edit);
  const auto& now = std::get<DifferentialEdit>(document.edits()[at].content);
  const EditList& base = document.stepBase().edits;
  const auto* before = at < base.size() ? std::get_if<DifferentialEdit>(&base[at].content) : nullptr;
  if (!before || before->model != now.model) before = &now;  // undone in the midst of an interaction
  const models::ParameterSpec& spec = specOf(now, parameter);
  return EditStepText::tr("Change %1 from %2 to %3")
      .arg(widgets::toQString(spec.label), widgets::displayValue(spec, before->edited.values[std::size_t(parameter)]),
           widgets::displayValue(spec, value));
}

/// One edit changed.
template <class Change>
void change(Document& document, int edit, const QString& text, const Change& change) {
  document.replaceEdits(editing::withEdit(document.edits(), std::size_t(edit), change), text);
}

}  // namespace

QString editName(const EditList& edits, int index) {
  const QString name = plainName(edits[std::size_t(index)]);
  int number = 1;
  for (int i = 0; i < index; ++i) number += plainName(edits[std::size_t(i)]) == name;
  return number == 1 ? name : EditStepText::tr("%1 %2").arg(name, QString::number(number));
}

void setParameter(Document& document, int parameter, const Rgb& value) {
  const int edit = activeIndex<DifferentialEdit>(document.state());
  if (edit < 0) return;
  document.replaceEdits(editing::withParameter(document.edits(), std::size_t(edit), std::size_t(parameter), value),
                        changeText(document, edit, parameter, value));
}

void resetParameter(Document& document, int parameter) {
  const int edit = activeIndex<DifferentialEdit>(document.state());
  if (edit < 0) return;
  const auto& active = std::get<DifferentialEdit>(document.edits()[std::size_t(edit)].content);
  const Rgb fitted = active.fitted.values[std::size_t(parameter)];
  document.installEdits(editing::withParameter(document.edits(), std::size_t(edit), std::size_t(parameter), fitted),
                        EditStepText::tr("Reset %1").arg(widgets::toQString(specOf(active, parameter).label)));
}

void resetParameters(Document& document) {
  const int edit = activeIndex<DifferentialEdit>(document.state());
  if (edit < 0) return;
  change(document, edit, EditStepText::tr("Reset all parameters"), [](Edit& one) {
    auto& active = std::get<DifferentialEdit>(one.content);
    active.edited = active.fitted;
    active.controls = models::defaultParameters(editing::artistControls());
  });
}

void setControl(Document& document, editing::ArtistControl control, const Rgb& value) {
  const int edit = activeIndex<DifferentialEdit>(document.state());
  if (edit < 0) return;
  document.replaceEdits(
      withControl(document, edit, control, value),
      EditStepText::tr("%1 to %2")
          .arg(widgets::toQString(specOf(control).label), widgets::displayValue(specOf(control), value)));
}

void setControls(Document& document, const models::ParameterValues& controls, const QString& text) {
  const int edit = activeIndex<DifferentialEdit>(document.state());
  if (edit < 0) return;
  document.replaceEdits(
      editing::withEdit(document.edits(), std::size_t(edit),
                        [&](Edit& one) { std::get<DifferentialEdit>(one.content).controls = controls; }),
      text);
}

void resetControl(Document& document, editing::ArtistControl control) {
  const int edit = activeIndex<DifferentialEdit>(document.state());
  if (edit < 0) return;
  document.installEdits(withControl(document, edit, control, Rgb(specOf(control).defaultValue)),
                        EditStepText::tr("Reset %1").arg(widgets::toQString(specOf(control).label)));
}

QString compositionName(editing::Composition composition) {
  return widgets::toQString(editing::compositionRecords[std::size_t(composition)].name);
}

void setComposition(Document& document, editing::Composition composition) {
  const int edit = activeIndex<DifferentialEdit>(document.state());
  if (edit < 0) return;
  document.installEdits(
      editing::withEdit(document.edits(), std::size_t(edit),
                        [&](Edit& one) { std::get<DifferentialEdit>(one.content).composition = composition; }),
      EditStepText::tr("Composition: %1").arg(compositionName(composition)));
}

void setKeepsAlbedo(Document& document, bool keepsAlbedo) {
  const int edit = activeIndex<DifferentialEdit>(document.state());
  if (edit < 0) return;
  document.installEdits(
      editing::withEdit(document.edits(), std::size_t(edit),
                        [&](Edit& one) { std::get<DifferentialEdit>(one.content).keepsAlbedo = keepsAlbedo; }),
      keepsAlbedo ? EditStepText::tr("Keep albedo") : EditStepText::tr("Let the albedo change"));
}

void setEditStrength(Document& document, int edit, double strength) {
  change(document, edit,
         EditStepText::tr("Set strength of %1 to %2 %")
             .arg(nameOf(document, edit), QString::number(100 * strength, 'f', 0)),
         [&](Edit& one) { one.strength = strength; });
}

void setEditEnabled(Document& document, int edit, bool enabled) {
  change(document, edit,
         (enabled ? EditStepText::tr("Show %1") : EditStepText::tr("Hide %1")).arg(nameOf(document, edit)),
         [&](Edit& one) { one.enabled = enabled; });
}

void renameEdit(Document& document, int edit, const QString& name) {
  EditList edits = editing::withEdit(document.edits(), std::size_t(edit),
                                     [&](Edit& one) { one.name = name.trimmed().toStdString(); });
  const QString text = EditStepText::tr("Rename %1 to %2").arg(nameOf(document, edit), editName(edits, edit));
  document.replaceEdits(std::move(edits), text);
}

void moveEdit(Document& document, int from, int to) {
  const QString text = to < from ? EditStepText::tr("Move %1 up") : EditStepText::tr("Move %1 down");
  document.replaceEdits(editing::moved(document.edits(), std::size_t(from), std::size_t(to)),
                        text.arg(nameOf(document, from)), to);
}

void duplicateEdit(Document& document, int edit) {
  document.replaceEdits(editing::inserted(document.edits(), std::size_t(edit) + 1, document.edits()[std::size_t(edit)]),
                        EditStepText::tr("Duplicate %1").arg(nameOf(document, edit)), edit + 1);
}

void deleteEdit(Document& document, int edit) {
  const int selected = document.state().selected;
  document.replaceEdits(editing::removed(document.edits(), std::size_t(edit)),
                        EditStepText::tr("Delete %1").arg(nameOf(document, edit)),
                        selected > edit ? selected - 1 : selected);
}

void pasteEdits(Document& document, const EditList& pasted) {
  const auto hasKindOf = [](const EditList& list, const Edit& edit) {
    return std::any_of(list.begin(), list.end(),
                       [&](const Edit& one) { return one.content.index() == edit.content.index(); });
  };
  const bool curves = std::holds_alternative<editing::FactorEdit>(pasted.front().content);
  std::optional<std::size_t> place;
  EditList edits;
  for (const Edit& edit : document.edits())
    if (!hasKindOf(pasted, edit))
      edits.push_back(edit);
    else if (!place)
      place = edits.size();
  const std::size_t first = place.value_or(curves ? 0 : edits.size());
  edits.insert(edits.begin() + std::ptrdiff_t(first), pasted.begin(), pasted.end());
  document.installEdits(
      std::move(edits),
      curves && pasted.size() == 1 ? EditStepText::tr("Paste factor curves") : EditStepText::tr("Paste edits"),
      int(first + pasted.size()) - 1);
}

void addEdit(Document& document, const Edit& edit) {
  const int selected = document.state().selected;
  const int place = selected < 0 ? int(document.edits().size()) : selected + 1;
  EditList edits = editing::inserted(document.edits(), std::size_t(place), edit);
  const QString text = EditStepText::tr("Add %1").arg(editName(edits, place));
  document.replaceEdits(std::move(edits), text, place);
}

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

QMimeData* toClipboard(const documents::EditDocument& document) {
  const std::string text = io::jsonText(documents::toJson(document), 2);
  auto* data = new QMimeData;
  data->setData(mimeType, QByteArray::fromStdString(text));
  data->setText(QString::fromStdString(text));
  return data;
}

editing::EditList editsFromClipboard(const QMimeData* data) {
  if (!data) return {};
  const QByteArray text = data->hasFormat(mimeType) ? data->data(mimeType) : data->text().toUtf8();
  try {
    editing::EditList edits = documents::documentFromText(text.toStdString()).edits;
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
