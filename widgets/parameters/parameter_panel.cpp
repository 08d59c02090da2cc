// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/parameter_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/inputs/collapsible_section.h"
#include "widgets/parameters/parameter_row.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::widgets {

namespace {
constexpr models::ParameterGroup groupOrder[] = {
    models::ParameterGroup::diffuse,   models::ParameterGroup::specular, models::ParameterGroup::fresnel,
    models::ParameterGroup::shadowing, models::ParameterGroup::layer,    models::ParameterGroup::coefficients,
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
  for (const models::ParameterGroup group : groupOrder) addGroup(group);
}

void ParameterPanel::addGroup(models::ParameterGroup group) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < m_spec->parameters.size(); ++i)
    if (m_spec->parameters[i].group == group) members.push_back(i);
  if (members.empty()) return;
  if (group != models::ParameterGroup::coefficients) {
    auto* title = new QLabel(groupTitle(group), m_content);
    title->setObjectName(QStringLiteral("groupTitle"));
    title->setForegroundRole(QPalette::PlaceholderText);
    m_content->layout()->addWidget(title);
    for (const std::size_t index : members) addRow(index, m_content);
    return;
  }
  auto* rows = new QWidget(m_content);
  auto* layout = new QVBoxLayout(rows);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(m_content->layout()->spacing());
  for (const std::size_t index : members) addRow(index, rows);
  auto* section = new CollapsibleSection(tr("%1 (%2)").arg(groupTitle(group)).arg(members.size()), rows, m_content);
  section->setExpanded(m_coefficientsShown);
  rows->setVisible(m_coefficientsShown);
  connect(section, &CollapsibleSection::expandedChanged, this, [this](bool shown) { m_coefficientsShown = shown; });
  m_content->layout()->addWidget(section);
}

void ParameterPanel::addRow(std::size_t index, QWidget* parent) {
  auto* row = new ParameterRow(m_spec->parameters[index], parent);
  parent->layout()->addWidget(row);
  m_rows[index] = row;
  connect(row, &ParameterRow::editingStarted, this, &ParameterPanel::editingStarted);
  connect(row, &ParameterRow::editingFinished, this, &ParameterPanel::editingFinished);
  connect(row, &ParameterRow::valueEdited, this,
          [this, index](const Rgb& value) { Q_EMIT valueEdited(int(index), value); });
  connect(row, &ParameterRow::resetRequested, this, [this, index] { Q_EMIT resetRequested(int(index)); });
}

void ParameterPanel::setValues(const models::ParameterValues& values, const models::ParameterValues& reference) {
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    m_rows[i]->setValue(values.values[i], reference.values[i]);
    const models::ParameterSpec& spec = m_spec->parameters[i];
    if (spec.activeWith.empty()) continue;
    const std::size_t switching = *m_spec->find(spec.activeWith);
    const models::ParameterSpec& choice = m_spec->parameters[switching];
    const bool active = std::lround(values.values[switching].x) == spec.activeChoice;
    m_rows[i]->setActive(active, tr("Has an effect only if %1 is set to \"%2\".")
                                     .arg(toQString(choice.label), displayValue(choice, Rgb(spec.activeChoice))));
  }
}

void ParameterPanel::showUnits() {
  for (ParameterRow* row : m_rows) row->showUnits();
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
