// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_controls.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QListView>
#include <cmath>

#include "widgets/acquisition/forbidden_regions_editor.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace gonio::app {

namespace {

using acquisition::SelectionMethod;

/// An item that stands for nothing yet is not offered.
void hideItem(QComboBox& box, int item, bool hidden) {
  static_cast<QListView*>(box.view())->setRowHidden(item, hidden);
}

}  // namespace

AcquisitionControls::AcquisitionControls(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 4, 0);
  form->setVerticalSpacing(4);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  buildSubject(*form);
  buildTraining(*form);
  buildSamples(*form);
  buildRig(*form);
  buildReconstruction(*form);
  // The column is narrow: long names are cut, not the boxes.
  for (QComboBox* box : {m_subject, m_training, m_method, m_reconstruction}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
  }
  hideItem(*m_subject, chosenMaterial, true);
  hideItem(*m_training, otherSet, true);
  connectParts();
  refresh();
}

void AcquisitionControls::connectParts() {
  connect(m_training, &QComboBox::activated, this, &AcquisitionControls::trainingActivated);
  connect(m_subject, &QComboBox::activated, this, [this](int index) {
    if (index == chooseMaterial) {
      m_subject->setCurrentIndex(m_lastSubject);
      return Q_EMIT subjectWanted();
    }
    m_lastSubject = index;
    refresh();
    Q_EMIT subjectEdited();
  });
  const auto edited = [this] {
    refresh();
    Q_EMIT planSettingsEdited();
  };
  connect(m_method, &QComboBox::activated, this, edited);
  connect(m_leaveOut, &QCheckBox::toggled, this, edited);
  connect(m_forbidden, &widgets::ForbiddenRegionsEditor::regionsEdited, this, edited);
  for (widgets::NumberField* number : {m_seed, m_largestAngle, m_separation})
    connect(number, &widgets::NumberField::valueEdited, this, edited);
  connect(m_seed, &widgets::NumberField::valueEdited, this, [this] {
    if (isNoisy()) Q_EMIT noiseEdited();
  });
  const auto count = [this, edited](double value) {
    setSamples(int(std::lround(value)));
    edited();
  };
  connect(m_samplesSlider, &widgets::ParameterSlider::numberEdited, this, count);
  connect(m_samplesSlider, &widgets::ParameterSlider::resetRequested, this, [count] { count(PlanSettings().samples); });
  connect(m_samples, &widgets::NumberField::valueEdited, this, count);
  for (widgets::NumberField* number : {m_noise, m_floor, m_misalignment})
    connect(number, &widgets::NumberField::valueEdited, this, [this] {
      refresh();
      Q_EMIT noiseEdited();
    });
  connect(m_reconstruction, &QComboBox::activated, this, &AcquisitionControls::reconstructionEdited);
}

void AcquisitionControls::trainingActivated(int index) {
  if (index == folder) {
    m_training->setCurrentIndex(m_lastTraining);
    return askForFolder();
  }
  m_lastTraining = index;
  refresh();
  Q_EMIT planSettingsEdited();
}

void AcquisitionControls::askForFolder() {
  auto* dialog = new QFileDialog(this, tr("Folder of Materials to Learn from"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    setTraining(folderTraining(path));
    Q_EMIT planSettingsEdited();
  });
  dialog->open();
}

void AcquisitionControls::setTraining(const TrainingSet& training) {
  m_otherTraining = training;
  m_training->setItemText(otherSet, training.name);
  hideItem(*m_training, otherSet, false);
  m_training->setCurrentIndex(otherSet);
  m_lastTraining = otherSet;
  refresh();
}

TrainingSet AcquisitionControls::training() const {
  switch (m_training->currentIndex()) {
    case fits:
      return fittedTraining();
    case library:
      return libraryTraining();
    case shownInLibrary:
      return {tr("what the library shows"), m_shownIds ? m_shownIds() : QStringList()};
    case otherSet:
      return m_otherTraining;
    default:
      return measuredTraining();
  }
}

PlanSettings AcquisitionControls::planSettings() const {
  PlanSettings settings;
  settings.training = training();
  settings.leaveOutReference = m_leaveOut->isChecked();
  settings.method = SelectionMethod(m_method->currentData().toInt());
  settings.samples = int(std::lround(m_samples->value()));
  settings.measurable = {m_largestAngle->value(), m_separation->value(), m_forbidden->regions()};
  settings.seed = std::uint64_t(std::llround(m_seed->value()));
  return settings;
}

void AcquisitionControls::setSamples(int samples) {
  m_samples->setValue(samples);
  m_samplesSlider->setNumber(samples);
  m_samplesSlider->setModified(samples != PlanSettings().samples);
}

AcquisitionControls::Subject AcquisitionControls::subject() const { return Subject(m_subject->currentIndex()); }

void AcquisitionControls::setMeasuredId(const QString& id) {
  m_measuredId = id;
  refresh();
}

void AcquisitionControls::setSubject(Subject subject) {
  m_lastSubject = int(subject);
  m_subject->setCurrentIndex(m_lastSubject);
  refresh();
}

void AcquisitionControls::setChosenSubject(const QString& name) {
  m_subject->setItemText(chosenMaterial, name);
  hideItem(*m_subject, chosenMaterial, false);
  setSubject(Subject::chosen);
}

acquisition::MeasurementNoise AcquisitionControls::noise() const {
  return {.relative = m_noise->value(),
          .absolute = m_floor->value(),
          .misalignment = m_misalignment->value(),
          .seed = std::uint64_t(std::llround(m_seed->value()))};
}

acquisition::ReconstructionOptions AcquisitionControls::reconstruction() const {
  acquisition::ReconstructionOptions options;
  const int index = m_reconstruction->currentIndex();
  if (index == sparse) options.method = acquisition::ReconstructionMethod::sparse;
  if (index != chosenRidge) options.ridge = acquisition::publishedRidge;
  options.components = mostComponents;
  return options;
}

bool AcquisitionControls::isNoisy() const {
  return m_noise->value() > 0 || m_floor->value() > 0 || m_misalignment->value() > 0;
}

void AcquisitionControls::setBusy(bool busy) {
  for (QWidget* part : std::initializer_list<QWidget*>{m_training, m_leaveOut, m_samplesSlider, m_samples, m_method,
                                                       m_largestAngle, m_separation, m_forbidden})
    part->setEnabled(!busy);
  if (busy)
    m_seed->setEnabled(false);
  else
    refresh();
}

void AcquisitionControls::refresh() {
  const auto method = SelectionMethod(m_method->currentData().toInt());
  m_seed->setEnabled(isNoisy() || method == SelectionMethod::random || method == SelectionMethod::conditionNumber);
  const bool simulated = subject() != Subject::none;
  for (widgets::NumberField* number : {m_noise, m_floor, m_misalignment}) number->setEnabled(simulated);
  const QStringList all = training().ids;
  const int count = int((m_leaveOut->isChecked() ? without(all, m_measuredId) : all).size());
  QString facts = count < 2 ? tr("%n materials: too few to learn from", nullptr, count)
                            : tr("%n materials, three signals each", nullptr, count);
  if (const int left = int(all.size()) - count; left > 0) facts += tr("; %n left out", nullptr, left);
  m_trainingFacts->setText(facts);
}

}  // namespace gonio::app

#include "moc_acquisition_controls.cpp"
