// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_controls.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

#include "app/gonio/acquisition/control_rows.h"

namespace gonio::app {

AcquisitionControls::AcquisitionControls(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 4, 0);
  form->setVerticalSpacing(4);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  m_measuredMaterial = new MeasuredMaterialRows(*form);
  m_training = new TrainingRows(*form);
  m_directions = new DirectionRows(*form);
  buildReconstruction(*form);
  connectRows();
  refresh();
}

void AcquisitionControls::buildReconstruction(QFormLayout& form) {
  form.addRow(rowHeading(tr("Reconstruction")));
  m_reconstruction = rowBox(
      tr("Method that computes the whole material from the measured values; all except Sparse give an uncertainty"));
  const std::pair<QString, QString> methods[] = {
      {tr("Local ridge"), tr("Ridge regression over up to %1 components; each training material is weighted by how "
                             "well it agrees with the measured values")
                              .arg(maxComponents)},
      {tr("Ridge, automatic η"), tr("Tikhonov regularisation over up to %1 components, with the η that predicts each "
                                    "sample best from all others (leave-one-out)")
                                     .arg(maxComponents)},
      {tr("Ridge, published η = %1").arg(acquisition::publishedRidge),
       tr("Ridge with the published η, over as many components as with automatic η. The published η suits about "
          "400 training signals; with fewer, it smooths too much.")},
      {tr("Ridge, published equation"),
       tr("The published equation (Tongbuasirilai 2023, eq. 5.14): η = %1, as many components as samples, and the same "
          "noise in all samples")
           .arg(acquisition::publishedRidge)},
      {tr("Sparse"), tr("Few components, chosen by orthogonal matching pursuit; it gives no uncertainty")}};
  for (const auto& [name, explanation] : methods) {
    m_reconstruction->addItem(name);
    m_reconstruction->setItemData(m_reconstruction->count() - 1, explanation, Qt::ToolTipRole);
  }
  form.addRow(tr("Reconstruct &by"), m_reconstruction);
}

void AcquisitionControls::connectRows() {
  const auto edited = [this] {
    refresh();
    Q_EMIT planSettingsEdited();
  };
  connect(m_measuredMaterial, &MeasuredMaterialRows::edited, this, &AcquisitionControls::refresh);
  connect(m_measuredMaterial, &MeasuredMaterialRows::noiseEdited, this, [this] {
    refresh();
    Q_EMIT noiseEdited();
  });
  connect(m_training, &TrainingRows::edited, this, edited);
  connect(m_directions, &DirectionRows::edited, this, edited);
  connect(m_directions, &DirectionRows::seedEdited, this, [this] {
    if (m_measuredMaterial->isNoisy()) Q_EMIT noiseEdited();
  });
  connect(m_reconstruction, &QComboBox::activated, this, &AcquisitionControls::reconstructionEdited);
}

PlanSettings AcquisitionControls::planSettings() const {
  PlanSettings settings;
  settings.training = m_training->training();
  settings.leaveOutReference = m_training->leavesMeasuredOut();
  settings.method = m_directions->method();
  settings.samples = m_directions->samples();
  settings.measurable = m_directions->measurable();
  settings.seed = m_directions->seed();
  return settings;
}

acquisition::MeasurementNoise AcquisitionControls::noise() const {
  return m_measuredMaterial->noise(m_directions->seed());
}

acquisition::ReconstructionOptions AcquisitionControls::reconstruction() const {
  const int index = m_reconstruction->currentIndex();
  if (index == printedRidge) return acquisition::publishedReconstruction();
  acquisition::ReconstructionOptions options;
  if (index == localRidge) options.method = acquisition::ReconstructionMethod::localRidge;
  if (index == sparse) options.method = acquisition::ReconstructionMethod::sparse;
  if (index == publishedRidge) options.ridge = acquisition::publishedRidge;
  options.components = maxComponents;
  return options;
}

void AcquisitionControls::setBusy(bool busy) {
  m_busy = busy;
  refresh();
}

void AcquisitionControls::refresh() {
  m_training->setEnabled(!m_busy);
  m_directions->setEnabled(!m_busy, m_measuredMaterial->isNoisy());
  m_training->refresh();
}

}  // namespace gonio::app

#include "moc_acquisition_controls.cpp"
