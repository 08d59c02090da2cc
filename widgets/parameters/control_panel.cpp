// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/control_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/parameters/parameter_row.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::widgets {

using editing::ArtistControl;

namespace {

/// A control may change many parameters; a line names so many of them, and its tooltip all.
constexpr qsizetype maxNamedChanges = 2;

/// The colour of the diffuse term is set where an artist looks for it.
constexpr ArtistControl controlBeforeDiffuse = ArtistControl::tint;

const models::ParameterSpec& specOf(ArtistControl control) {
  return editing::artistControls().parameters[std::size_t(control)];
}

/// A control that moves on while its parameter stays at a limit needs an explanation.
QString limitText(const models::ParameterSpec& parameter, const Rgb& value) {
  const auto isReached = [&](double limit) { return value.x == limit || value.y == limit || value.z == limit; };
  if (isReached(parameter.hardMax)) return ControlPanel::tr(" (maximum)");
  return isReached(parameter.hardMin) && parameter.hardMin > 0 ? ControlPanel::tr(" (minimum)") : QString();
}

QStringList changesOf(ArtistControl control, const editing::DifferentialEdit& edit) {
  const models::ModelSpec& spec = edit.model->spec();
  QStringList changes;
  for (const editing::ControlledParameter& one : editing::changesBy(control, spec, edit.edited, edit.controls)) {
    const models::ParameterSpec& parameter = spec.parameters[one.parameter];
    changes << ControlPanel::tr("%1 %2 \u2192 %3")
                   .arg(toQString(parameter.label), displayValue(parameter, one.before),
                        displayValue(parameter, one.after) + limitText(parameter, one.after));
  }
  return changes;
}

QString shortened(const QStringList& changes) {
  const QString named = changes.mid(0, maxNamedChanges).join(QStringLiteral("; "));
  const qsizetype others = changes.size() - maxNamedChanges;
  return others > 0 ? ControlPanel::tr("%1 and %2 more").arg(named).arg(others) : named;
}

}  // namespace

ControlPanel::ControlPanel(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this)), m_line(new QLabel) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_line->setObjectName(QStringLiteral("changes"));
  m_line->setForegroundRole(QPalette::PlaceholderText);
  m_line->setIndent(fontMetrics().height());
  m_line->setMinimumWidth(1);  // a long text must not widen the whole inspector
  m_layout->addWidget(m_line);
  setEdit(nullptr);
}

void ControlPanel::setEdit(const editing::DifferentialEdit* edit, const QString& emptyText) {
  if (!edit) return showEmpty(emptyText.isEmpty() ? tr("Fit a model to edit this material.") : emptyText);
  if (m_controls.empty() || m_spec != &edit->model->spec()) build(edit->model->spec());
  for (std::size_t i = 0; i < m_controls.size(); ++i)
    m_controls[i].row->setValue(edit->controls.values[i], Rgb(specOf(ArtistControl(i)).defaultValue));
  if (m_diffuse)
    m_diffuse->setValue(edit->edited.values[std::size_t(m_diffuseParameter)],
                        edit->fitted.values[std::size_t(m_diffuseParameter)]);
  showChanges(*edit);
}

void ControlPanel::showEmpty(const QString& text) {
  m_spec = nullptr;
  m_controls.clear();
  m_diffuse = nullptr;
  delete m_content;
  auto* hint = new QLabel(text, this);
  hint->setObjectName(QStringLiteral("hint"));
  hint->setWordWrap(true);
  hint->setEnabled(false);
  m_content = hint;
  m_layout->insertWidget(0, m_content);
  m_line->hide();
}

void ControlPanel::build(const models::ModelSpec& spec) {
  m_spec = &spec;
  m_moved.reset();
  m_controls.clear();
  m_diffuse = nullptr;
  delete m_content;
  m_content = new QWidget(this);
  m_layout->insertWidget(0, m_content);
  m_line->show();
  auto* layout = new QVBoxLayout(m_content);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(fontMetrics().height() / 3);
  for (std::size_t i = 0; i < editing::artistControls().parameters.size(); ++i) {
    addControl(ArtistControl(i));
    if (ArtistControl(i) == controlBeforeDiffuse) addDiffuse();
  }
}

ParameterRow* ControlPanel::addRow(const models::ParameterSpec& spec) {
  auto* row = new ParameterRow(spec, m_content);
  m_content->layout()->addWidget(row);
  connect(row, &ParameterRow::editingStarted, this, &ControlPanel::editingStarted);
  connect(row, &ParameterRow::editingFinished, this, &ControlPanel::editingFinished);
  return row;
}

void ControlPanel::addControl(ArtistControl control) {
  ParameterRow* row = addRow(specOf(control));
  connect(row, &ParameterRow::valueEdited, this, [this, control](const Rgb& value) {
    m_moved = control;
    Q_EMIT controlEdited(control, value);
  });
  connect(row, &ParameterRow::resetRequested, this, [this, control] { Q_EMIT controlResetRequested(control); });
  row->setActive(editing::actsOn(control, *m_spec),
                 tr("The model %1 has no parameter for this control. The model Layered lobes has parameters "
                    "for every control.")
                     .arg(toQString(m_spec->name)));
  m_controls.push_back({row});
}

void ControlPanel::addDiffuse() {
  const auto diffuse =
      std::ranges::find(m_spec->parameters, models::ParameterRole::diffuse, &models::ParameterSpec::role);
  if (diffuse == m_spec->parameters.end()) return;
  m_diffuseParameter = int(diffuse - m_spec->parameters.begin());
  m_diffuseSpec = *diffuse;
  m_diffuseSpec->label = "Diffuse colour";
  m_diffuse = addRow(*m_diffuseSpec);
  connect(m_diffuse, &ParameterRow::valueEdited, this,
          [this](const Rgb& value) { Q_EMIT diffuseEdited(m_diffuseParameter, value); });
  connect(m_diffuse, &ParameterRow::resetRequested, this, [this] { Q_EMIT diffuseResetRequested(m_diffuseParameter); });
}

/// One line below all rows: lines between them would move the next slider away from under the hand.
void ControlPanel::showChanges(const editing::DifferentialEdit& edit) {
  QStringList all;
  std::optional<ArtistControl> first;
  for (std::size_t i = 0; i < m_controls.size(); ++i) {
    m_controls[i].changes = changesOf(ArtistControl(i), edit);
    if (m_controls[i].changes.isEmpty()) continue;
    if (!first) first = ArtistControl(i);
    all << tr("%1: %2").arg(toQString(specOf(ArtistControl(i)).label),
                            m_controls[i].changes.join(QStringLiteral("; ")));
  }
  const auto shown = m_moved && !changes(*m_moved).isEmpty() ? m_moved : first;
  // Equal texts too would make a label and its tooltip anew, at each step of a slider.
  const QString text = shown ? changes(*shown) : QString(), toolTip = all.join('\n');
  if (text != m_line->text()) m_line->setText(text);
  if (toolTip != m_line->toolTip()) m_line->setToolTip(toolTip);
}

QString ControlPanel::changes(ArtistControl control) const {
  return m_controls.empty() ? QString() : shortened(m_controls[std::size_t(control)].changes);
}

ParameterRow* ControlPanel::row(ArtistControl control) const {
  return m_controls.empty() ? nullptr : m_controls[std::size_t(control)].row;
}

const ParameterRow* ControlPanel::currentRow() const {
  std::vector<const ParameterRow*> rows;
  for (const Control& control : m_controls) rows.push_back(control.row);
  if (m_diffuse) rows.push_back(m_diffuse);
  const QWidget* focus = focusWidget();
  const auto hovered = std::ranges::find_if(rows, [](const ParameterRow* row) { return row->underMouse(); });
  if (hovered != rows.end()) return *hovered;
  const auto focused =
      std::ranges::find_if(rows, [&](const ParameterRow* row) { return focus && row->isAncestorOf(focus); });
  return focused == rows.end() ? nullptr : *focused;
}

std::optional<ArtistControl> ControlPanel::currentControl() const {
  const ParameterRow* current = currentRow();
  for (std::size_t i = 0; i < m_controls.size(); ++i)
    if (m_controls[i].row == current) return ArtistControl(i);
  return {};
}

std::optional<int> ControlPanel::currentDiffuseParameter() const {
  if (!m_diffuse || currentRow() != m_diffuse) return {};
  return m_diffuseParameter;
}

}  // namespace gonio::widgets

#include "moc_control_panel.cpp"
