// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/parameter_panel.h"

#include <QLabel>
#include <QVBoxLayout>

#include "widgets/parameters/parameter_row.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::widgets {

namespace {
constexpr models::ParameterGroup groupOrder[] = {models::ParameterGroup::diffuse, models::ParameterGroup::specular,
                                                 models::ParameterGroup::fresnel, models::ParameterGroup::shadowing,
                                                 models::ParameterGroup::layer,    models::ParameterGroup::coefficients,
                                                 models::ParameterGroup::convention};
}

ParameterPanel::ParameterPanel(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this)) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  setModel(nullptr);
}

void ParameterPanel::setModel(const models::ModelSpec* spec, const QString& emptyText) {
  m_rows.clear();
  delete m_content;
  m_content = new QWidget(this);
  m_layout->addWidget(m_content);
  m_spec = spec;
  auto* content = new QVBoxLayout(m_content);
  content->setContentsMargins(0, 0, 0, 0);
  content->setSpacing(fontMetrics().height() / 3);
  if (!spec) {
    auto* hint = new QLabel(emptyText.isEmpty() ? tr("Fit a model to edit this material.") : emptyText, m_content);
    hint->setWordWrap(true);
    hint->setEnabled(false);
    content->addWidget(hint);
    return;
  }
  m_rows.resize(spec->parameters.size());
  for (const models::ParameterGroup group : groupOrder) {
    bool titled = false;
    for (std::size_t i = 0; i < spec->parameters.size(); ++i) {
      if (spec->parameters[i].group != group) continue;
      if (!titled) {
        auto* title = new QLabel(groupTitle(group), m_content);
        title->setObjectName(QStringLiteral("groupTitle"));
        title->setForegroundRole(QPalette::PlaceholderText);
        content->addWidget(title);
        titled = true;
      }
      addRow(i);
    }
  }
}

void ParameterPanel::addRow(std::size_t index) {
  auto* row = new ParameterRow(m_spec->parameters[index], m_content);
  m_content->layout()->addWidget(row);
  m_rows[index] = row;
  connect(row, &ParameterRow::editingStarted, this, &ParameterPanel::editingStarted);
  connect(row, &ParameterRow::editingFinished, this, &ParameterPanel::editingFinished);
  connect(row, &ParameterRow::valueEdited, this,
          [this, index](const Rgb& value) { Q_EMIT valueEdited(int(index), value); });
  connect(row, &ParameterRow::resetRequested, this, [this, index] { Q_EMIT resetRequested(int(index)); });
}

void ParameterPanel::setValues(const models::ParameterValues& values, const models::ParameterValues& reference) {
  for (std::size_t i = 0; i < m_rows.size(); ++i) m_rows[i]->setValue(values.values[i], reference.values[i]);
}

int ParameterPanel::currentParameter() const {
  for (std::size_t i = 0; i < m_rows.size(); ++i)
    if (m_rows[i]->underMouse()) return int(i);
  for (std::size_t i = 0; i < m_rows.size(); ++i)
    if (const QWidget* focus = focusWidget(); focus && m_rows[i]->isAncestorOf(focus)) return int(i);
  return -1;
}

}  // namespace gonio::widgets

#include "moc_parameter_panel.cpp"
