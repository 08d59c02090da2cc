// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/direction_rows.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <cmath>

#include "app/gonio/acquisition/acquisition_session.h"
#include "app/gonio/acquisition/control_rows.h"
#include "widgets/acquisition/forbidden_regions_editor.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace gonio::app {

DirectionRows::DirectionRows(QFormLayout& form) : QObject(&form) {
  buildSamples(form);
  buildMethod(form);
  buildRig(form);
  setSamples(PlanSettings().samples);
  connectParts();
}

void DirectionRows::buildSamples(QFormLayout& form) {
  form.addRow(rowHeading(tr("Directions")));
  const QString toolTip = tr("Number m of direction pairs to measure, %1 to %2; more samples lower the error")
                              .arg(AcquisitionSession::minSamples)
                              .arg(AcquisitionSession::maxSamples);
  m_samplesSlider = new widgets::ParameterSlider;
  m_samplesSlider->setRange(AcquisitionSession::minSamples, AcquisitionSession::maxSamples,
                            models::ParameterScale::linear);
  m_samplesSlider->setReference(PlanSettings().samples);
  m_samplesSlider->setAccessibleName(tr("Samples"));
  m_samplesSlider->setToolTip(toolTip);
  m_samples = rowField(tr("Samples"), toolTip, AcquisitionSession::minSamples, AcquisitionSession::maxSamples, 1, {});
  m_samples->setFixedWidth(3 * m_samples->fontMetrics().height());
  auto* row = new QHBoxLayout;
  row->addWidget(m_samplesSlider, 1);
  row->addWidget(m_samples);
  auto* label = new QLabel(tr("Sam&ples m"));
  label->setBuddy(m_samples);
  form.addRow(label, row);
}

void DirectionRows::buildMethod(QFormLayout& form) {
  m_method = rowBox(tr("Method that chooses the directions"));
  const std::tuple<acquisition::SelectionMethod, QString, QString> methods[] = {
      {acquisition::SelectionMethod::simultaneousPursuit, tr("SOMP, all signals"),
       tr("Simultaneous orthogonal matching pursuit over all training signals, one for each colour channel of each "
          "material (FROST)")},
      {acquisition::SelectionMethod::simultaneousPursuitFirstColumns, tr("SOMP, as released"),
       tr("SOMP over only the first m training signals, as in the authors' released code")},
      {acquisition::SelectionMethod::conditionNumber, tr("Condition number"),
       tr("Minimises the condition number (Nielsen et al. 2015); much slower, especially for many samples")},
      {acquisition::SelectionMethod::random, tr("Random"),
       tr("Chooses measurable cells at random with equal probability")},
      {acquisition::SelectionMethod::uniform, tr("Uniform"), tr("Spreads the samples evenly over the directions")},
      {acquisition::SelectionMethod::aOptimal, tr("A-optimal"),
       tr("Chooses the directions that, once measured, leave the smallest expected error of all values (Bayesian "
          "A-optimal design)")}};
  for (const auto& [method, name, explanation] : methods) {
    m_method->addItem(name, int(method));
    m_method->setItemData(m_method->count() - 1, explanation, Qt::ToolTipRole);
  }
  form.addRow(tr("Metho&d"), m_method);
  m_seed = rowField(
      tr("Seed"),
      tr("Seed of the methods Random and Condition number, and of the noise; change it to get other random values"), 1,
      1e6, 1, {});
  form.addRow(tr("Seed"), m_seed);
  m_seed->setValue(1);
}

void DirectionRows::buildRig(QFormLayout& form) {
  form.addRow(rowHeading(tr("Limits of the rig")));
  const acquisition::MeasurableDirections usual;
  m_maxAngle = rowField(tr("Max. polar angle"), tr("Maximum polar angle of light and viewer"), radians(10), halfPi,
                        radians(1), QStringLiteral("°"), degrees(1));
  m_maxAngle->setValue(usual.maxPolarAngle);
  m_separation = rowField(tr("Min. separation"),
                          tr("Minimum angle between light and viewer; below it, one arm occludes the other"), 0, halfPi,
                          radians(1), QStringLiteral("°"), degrees(1));
  m_separation->setValue(usual.minSeparation);
  form.addRow(tr("Max. polar angle"), m_maxAngle);
  form.addRow(tr("Min. separation"), m_separation);
  m_forbidden = new widgets::ForbiddenRegionsEditor;
  form.addRow(new QLabel(tr("Forbidden regions [°]")));
  form.addRow(m_forbidden);
}

void DirectionRows::connectParts() {
  connect(m_method, &QComboBox::activated, this, &DirectionRows::edited);
  connect(m_forbidden, &widgets::ForbiddenRegionsEditor::regionsEdited, this, &DirectionRows::edited);
  for (widgets::NumberField* number : {m_seed, m_maxAngle, m_separation})
    connect(number, &widgets::NumberField::valueEdited, this, &DirectionRows::edited);
  connect(m_seed, &widgets::NumberField::valueEdited, this, &DirectionRows::seedEdited);
  const auto count = [this](double value) {
    setSamples(int(std::lround(value)));
    Q_EMIT edited();
  };
  connect(m_samplesSlider, &widgets::ParameterSlider::numberEdited, this, count);
  connect(m_samplesSlider, &widgets::ParameterSlider::resetRequested, this, [count] { count(PlanSettings().samples); });
  connect(m_samples, &widgets::NumberField::valueEdited, this, count);
}

int DirectionRows::samples() const { return int(std::lround(m_samples->value())); }

void DirectionRows::setSamples(int samples) {
  m_samples->setValue(samples);
  m_samplesSlider->setNumber(samples);
  m_samplesSlider->setModified(samples != PlanSettings().samples);
}

acquisition::SelectionMethod DirectionRows::method() const {
  return acquisition::SelectionMethod(m_method->currentData().toInt());
}

acquisition::MeasurableDirections DirectionRows::measurable() const {
  return {m_maxAngle->value(), m_separation->value(), m_forbidden->regions()};
}

std::uint64_t DirectionRows::seed() const { return std::uint64_t(std::llround(m_seed->value())); }

void DirectionRows::setEnabled(bool enabled, bool noisy) {
  for (QWidget* part :
       std::initializer_list<QWidget*>{m_samplesSlider, m_samples, m_method, m_maxAngle, m_separation, m_forbidden})
    part->setEnabled(enabled);
  using Method = acquisition::SelectionMethod;
  m_seed->setEnabled(enabled && (noisy || method() == Method::random || method() == Method::conditionNumber));
}

}  // namespace gonio::app

#include "moc_direction_rows.cpp"
