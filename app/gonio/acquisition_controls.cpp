// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition_controls.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QListView>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/acquisition/forbidden_regions_editor.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace gonio::app {

namespace {

using acquisition::SelectionMethod;

enum Training { measured, fits, library, shownInLibrary, otherSet, folder };
enum Subjects { openMaterial, chosenMaterial, noMaterial, chooseMaterial };
enum Reconstructions { publishedRidge, chosenRidge, sparse };

QLabel* heading(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  label->setContentsMargins(0, 6, 0, 0);
  return label;
}

widgets::NumberField* field(const QString& name, const QString& toolTip, double least, double most, double step,
                            const QString& unit, double factor = 1) {
  auto* number = new widgets::NumberField;
  number->setRange(least, most);
  number->setStep(step);
  number->setUnit(unit, factor);
  number->setAccessibleName(name);
  number->setToolTip(toolTip);
  number->setFixedWidth(6 * number->fontMetrics().height());
  return number;
}

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
  connectParts();
  refresh();
}

void AcquisitionControls::buildSubject(QFormLayout& form) {
  m_subject = new QComboBox;
  m_subject->addItems({tr("The open material"), QString(), tr("None: values of a rig"), tr("Choose...")});
  m_subject->setToolTip(
      tr("The material that is measured in simulation, and that the reconstruction is compared with. With values of a "
         "rig there may be none."));
  hideItem(*m_subject, chosenMaterial, true);
  form.addRow(tr("&Measure"), m_subject);
  m_noise = field(tr("Noise"), tr("Standard deviation of a simulated reading, as a share of its value"), 0, 1, 0.01,
                  tr("%"), 100);
  m_floor = field(tr("Noise floor"), tr("Standard deviation of the sensor in the dark, beside its relative noise"), 0,
                  10, 1e-3, tr("1/sr"));
  m_misalignment = field(tr("Misalignment"),
                         tr("Standard deviation of the direction of each arm, along each of two "
                            "axes"),
                         0, radians(10), radians(0.1), QStringLiteral("°"), degrees(1));
  form.addRow(tr("N&oise"), m_noise);
  form.addRow(tr("Noise &floor"), m_floor);
  form.addRow(tr("Misali&gnment"), m_misalignment);
}

void AcquisitionControls::buildTraining(QFormLayout& form) {
  form.addRow(heading(tr("Training set")));
  m_training = new QComboBox;
  m_training->addItems({tr("Measured, of the library"), tr("Published fits, of the library"), tr("The whole library"),
                        tr("What the library shows"), QString(), tr("A folder of files...")});
  m_training->setToolTip(
      tr("The materials from which it is learned what materials are like.\n"
         "\"What the library shows\": those that its search leaves, also of a folder."));
  hideItem(*m_training, otherSet, true);
  form.addRow(tr("&Learn from"), m_training);
  m_leaveOut = new QCheckBox(tr("Leave out the measured material"));
  m_leaveOut->setToolTip(
      tr("Neither the material that is measured nor another file of the same name is learned from: otherwise its "
         "reconstruction looks better than that of a new material."));
  m_leaveOut->setChecked(true);
  form.addRow(m_leaveOut);
  m_trainingFacts = new QLabel;
  m_trainingFacts->setForegroundRole(QPalette::PlaceholderText);
  m_trainingFacts->setWordWrap(true);
  form.addRow(m_trainingFacts);
}

void AcquisitionControls::buildSamples(QFormLayout& form) {
  form.addRow(heading(tr("Directions")));
  const QString toolTip = tr("m: how many pairs of directions are measured, %1 to %2")
                              .arg(AcquisitionSession::fewestSamples)
                              .arg(AcquisitionSession::mostSamples);
  m_samplesSlider = new widgets::ParameterSlider;
  m_samplesSlider->setRange(AcquisitionSession::fewestSamples, AcquisitionSession::mostSamples,
                            models::ParameterScale::linear);
  m_samplesSlider->setReference(PlanSettings().samples);
  m_samplesSlider->setAccessibleName(tr("Samples"));
  m_samplesSlider->setToolTip(toolTip);
  m_samples = field(tr("Samples"), toolTip, AcquisitionSession::fewestSamples, AcquisitionSession::mostSamples, 1, {});
  m_samples->setFixedWidth(3 * fontMetrics().height());
  auto* row = new QHBoxLayout;
  row->addWidget(m_samplesSlider, 1);
  row->addWidget(m_samples);
  auto* label = new QLabel(tr("&Samples m"));
  label->setBuddy(m_samples);
  form.addRow(label, row);
  m_method = new QComboBox;
  const std::tuple<SelectionMethod, QString, QString> methods[] = {
      {SelectionMethod::simultaneousPursuit, tr("SOMP, all signals"),
       tr("Simultaneous orthogonal matching pursuit over all training signals (FROST)")},
      {SelectionMethod::simultaneousPursuitFirstColumns, tr("SOMP, as released"),
       tr("The same over the first signals alone, as many as there are samples: what the authors' code does")},
      {SelectionMethod::conditionNumber, tr("Condition number"),
       tr("The search of Nielsen et al. 2015: slower by far, the more so the more samples")},
      {SelectionMethod::random, tr("Random"), tr("Every measurable cell as likely as any other")},
      {SelectionMethod::uniform, tr("Uniform"), tr("Spread evenly over the directions")}};
  for (const auto& [method, name, explanation] : methods) {
    m_method->addItem(name, int(method));
    m_method->setItemData(m_method->count() - 1, explanation, Qt::ToolTipRole);
  }
  m_method->setToolTip(tr("How the directions are chosen"));
  form.addRow(tr("M&ethod"), m_method);
  m_seed = field(tr("Seed"), tr("Another number: other random directions, other noise"), 1, 1e6, 1, {});
  form.addRow(tr("See&d"), m_seed);
  setSamples(PlanSettings().samples);
  m_seed->setValue(1);
}

void AcquisitionControls::buildRig(QFormLayout& form) {
  form.addRow(heading(tr("What the rig can see")));
  const acquisition::MeasurableDirections usual;
  m_largestAngle = field(tr("Largest polar angle"), tr("Neither light nor viewer gets nearer to the horizon"),
                         radians(10), halfPi, radians(1), QStringLiteral("°"), degrees(1));
  m_largestAngle->setValue(usual.largestPolarAngle);
  m_separation = field(tr("Arms apart"),
                       tr("The least angle between light and viewer: nearer, one arm stands before "
                          "the other"),
                       0, halfPi, radians(1), QStringLiteral("°"), degrees(1));
  m_separation->setValue(usual.smallestSeparation);
  form.addRow(tr("Largest θ"), m_largestAngle);
  form.addRow(tr("Arms apart"), m_separation);
  m_forbidden = new widgets::ForbiddenRegionsEditor;
  form.addRow(new QLabel(tr("Out of reach, degrees")));
  form.addRow(m_forbidden);
}

void AcquisitionControls::buildReconstruction(QFormLayout& form) {
  form.addRow(heading(tr("Reconstruction")));
  m_reconstruction = new QComboBox;
  const std::pair<QString, QString> methods[] = {
      {tr("Ridge, η = %1").arg(acquisition::publishedRidge),
       tr("Tikhonov regularisation with the η of the publications")},
      {tr("Ridge, η by leave-one-out"), tr("With the η that predicts each sample best from all others")},
      {tr("Sparse"), tr("Few components, chosen by orthogonal matching pursuit; tells no uncertainty")}};
  for (const auto& [name, explanation] : methods) {
    m_reconstruction->addItem(name);
    m_reconstruction->setItemData(m_reconstruction->count() - 1, explanation, Qt::ToolTipRole);
  }
  m_reconstruction->setToolTip(tr("How the material follows from its values"));
  form.addRow(tr("&By"), m_reconstruction);
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
  if (index == chosenRidge) options.ridge.reset();
  return options;
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
  const bool isNoisy = m_noise->value() > 0 || m_floor->value() > 0 || m_misalignment->value() > 0;
  m_seed->setEnabled(isNoisy || method == SelectionMethod::random || method == SelectionMethod::conditionNumber);
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
