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

#include "app/gonio/acquisition/acquisition_session.h"
#include "core/study/learned_basis.h"
#include "widgets/acquisition/forbidden_regions_editor.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace gonio::app {

QLabel* rowHeading(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  label->setContentsMargins(0, 6, 0, 0);
  return label;
}

widgets::NumberField* rowField(const QString& name, const QString& toolTip, double minimum, double maximum, double step,
                               const QString& unit, double factor) {
  auto* number = new widgets::NumberField;
  number->setRange(minimum, maximum);
  number->setStep(step);
  number->setUnit(unit, factor);
  number->setAccessibleName(name);
  number->setToolTip(toolTip);
  number->setFixedWidth(6 * number->fontMetrics().height());
  return number;
}

QComboBox* rowBox(const QString& toolTip) {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  box->setToolTip(toolTip);
  return box;
}

void hideItem(QComboBox& box, int item, bool hidden) {
  static_cast<QListView*>(box.view())->setRowHidden(item, hidden);
}

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
      {acquisition::SelectionMethod::automatic, tr("Automatic"),
       tr("A-optimal for up to %n samples, SOMP over all signals for more", nullptr, acquisition::mostAOptimalSamples)},
      {acquisition::SelectionMethod::simultaneousPursuit, tr("SOMP, all signals"),
       tr("Simultaneous orthogonal matching pursuit over all training signals, one for each colour channel of each "
          "material (FROST)")},
      {acquisition::SelectionMethod::simultaneousPursuitFirstColumns, tr("SOMP, as released"),
       tr("SOMP over only the first m training signals, as in the authors' released code")},
      {acquisition::SelectionMethod::simultaneousPursuitUnnormalised, tr("SOMP, as printed"),
       tr("SOMP over all training signals without the normalisation of the columns (Tongbuasirilai 2023, Algorithm "
          "4)")},
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
  m_signals = rowBox(
      tr("What the method sees of the training set: its principal components, or the atoms of the bundled dictionaries "
         "with the largest variances in it,\nwhich take some minutes to learn. The material is reconstructed from "
         "principal components in both cases."));
  m_signals->addItems({tr("Principal components"), tr("Dictionary atoms")});
  form.addRow(tr("O&ver"), m_signals);
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
  for (QComboBox* box : {m_method, m_signals}) connect(box, &QComboBox::activated, this, &DirectionRows::edited);
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

bool DirectionRows::isOverAtoms() const { return m_signals->currentIndex() == 1; }

acquisition::MeasurableDirections DirectionRows::measurable() const {
  return {m_maxAngle->value(), m_separation->value(), m_forbidden->regions()};
}

std::uint64_t DirectionRows::seed() const { return std::uint64_t(std::llround(m_seed->value())); }

void DirectionRows::setEnabled(bool enabled, bool noisy) {
  for (QWidget* part : std::initializer_list<QWidget*>{m_samplesSlider, m_samples, m_method, m_signals, m_maxAngle,
                                                       m_separation, m_forbidden})
    part->setEnabled(enabled);
  using Method = acquisition::SelectionMethod;
  m_seed->setEnabled(enabled && (noisy || method() == Method::random || method() == Method::conditionNumber));
}

TrainingRows::TrainingRows(QFormLayout& form)
    : QObject(&form),
      m_box(rowBox(
          tr("Training set: the reconstruction uses the principal components of these materials.\n"
             "Near-measured copies are neural fits of measured materials. They cover more materials than the measured "
             "ones alone; preparing them takes about a minute the first time.\n"
             "\"Materials shown in the library\": the materials that match the current search, including those of an "
             "open library folder."))),
      m_class(rowBox(tr("Part of the training set that is used. A material is glossy if its luminance in the mirror "
                        "direction at 15, 30 or 45 degrees is at least %1 times that beside the plane of incidence")
                         .arg(study::glossyContrast))),
      m_leaveOut(new QCheckBox(tr("Exclude the measured material"))),
      m_facts(new QLabel) {
  build(form);
  connect(m_box, &QComboBox::activated, this, &TrainingRows::activated);
  connect(m_class, &QComboBox::activated, this, &TrainingRows::edited);
  connect(m_leaveOut, &QCheckBox::toggled, this, &TrainingRows::edited);
}

void TrainingRows::build(QFormLayout& form) {
  form.addRow(rowHeading(tr("Training set")));
  m_box->addItems({tr("Measured materials"), tr("Near-measured copies of MERL"), tr("Published fits"),
                   tr("Measured and near-measured"), tr("Materials shown in the library"), QString(), tr("Folder...")});
  hideItem(*m_box, otherSet, true);
  m_box->setCurrentIndex(library);
  m_last = library;
  form.addRow(tr("Materia&ls"), m_box);
  m_class->addItems({tr("All"), tr("Diffuse"), tr("Glossy")});  // in the order of study::MaterialClass
  form.addRow(tr("Class"), m_class);
  m_leaveOut->setToolTip(
      tr("Excludes the measured material, and files of the same name, from the training set; otherwise the error is "
         "lower than for a new material"));
  m_leaveOut->setChecked(true);
  form.addRow(m_leaveOut);
  m_facts->setForegroundRole(QPalette::PlaceholderText);
  m_facts->setWordWrap(true);
  form.addRow(m_facts);
}

void TrainingRows::activated(int index) {
  if (index == folder) {
    m_box->setCurrentIndex(m_last);
    return askForFolder();
  }
  m_last = index;
  Q_EMIT edited();
}

void TrainingRows::askForFolder() {
  auto* dialog = new QFileDialog(m_box, tr("Training Set Folder"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    setTraining(folderTraining(path));
    Q_EMIT edited();
  });
  dialog->open();
}

void TrainingRows::setTraining(const TrainingSet& training) {
  m_otherSet = training;
  m_box->setItemText(otherSet, training.name);
  hideItem(*m_box, otherSet, false);
  m_box->setCurrentIndex(otherSet);
  m_last = otherSet;
  refresh();
}

TrainingSet TrainingRows::training() const {
  switch (m_box->currentIndex()) {
    case nearMeasured:
      return nearMeasuredTraining();
    case fits:
      return fittedTraining();
    case library:
      return libraryTraining();
    case shownInLibrary:
      return {tr("materials shown in the library"), m_shownIds ? m_shownIds() : QStringList()};
    case otherSet:
      return m_otherSet;
    default:
      return measuredTraining();
  }
}

study::MaterialClass TrainingRows::materialClass() const { return study::MaterialClass(m_class->currentIndex()); }

bool TrainingRows::leavesMeasuredOut() const { return m_leaveOut->isChecked(); }

void TrainingRows::setMeasuredId(const QString& id) {
  m_measuredId = id;
  refresh();
}

void TrainingRows::setEnabled(bool enabled) {
  for (QWidget* part : std::initializer_list<QWidget*>{m_box, m_class, m_leaveOut}) part->setEnabled(enabled);
}

void TrainingRows::refresh() {
  const QStringList all = training().ids;
  const int count = int((leavesMeasuredOut() ? without(all, m_measuredId) : all).size());
  QString facts = count < 2 ? tr("Materials: %n; a training set needs at least 2", nullptr, count)
                            : tr("%n materials, one signal for each colour channel", nullptr, count);
  if (const int left = int(all.size()) - count; left > 0) facts += tr("; %n excluded", nullptr, left);
  m_facts->setText(facts);
}

MeasuredMaterialRows::MeasuredMaterialRows(QFormLayout& form)
    : QObject(&form),
      m_box(rowBox(tr("Material that is measured in simulation and compared with the reconstruction; choose None for "
                      "values measured with a rig"))) {
  build(form);
  connect(m_box, &QComboBox::activated, this, &MeasuredMaterialRows::activated);
  for (widgets::NumberField* number : {m_noise, m_floor, m_misalignment})
    connect(number, &widgets::NumberField::valueEdited, this, &MeasuredMaterialRows::noiseEdited);
  refresh();
}

void MeasuredMaterialRows::build(QFormLayout& form) {
  m_box->addItems({tr("The open material"), QString(), tr("None (measured values)"), tr("Choose...")});
  hideItem(*m_box, chosenMaterial, true);
  form.addRow(tr("Meas&ure"), m_box);
  m_noise = rowField(tr("Noise"), tr("Standard deviation of a simulated reading, in percent of its value"), 0, 1, 0.01,
                     tr("%"), 100);
  m_floor = rowField(tr("Noise floor"),
                     tr("Standard deviation of a simulated reading in the dark, in addition to the relative noise"), 0,
                     10, 1e-3, tr("1/sr"));
  m_misalignment =
      rowField(tr("Misalignment"),
               tr("Standard deviation of the pointing error of each arm, about each of two axes, in degrees"), 0,
               radians(10), radians(0.1), QStringLiteral("°"), degrees(1));
  form.addRow(tr("&Noise"), m_noise);
  form.addRow(tr("Noise floor"), m_floor);
  form.addRow(tr("Misali&gnment"), m_misalignment);
}

void MeasuredMaterialRows::activated(int index) {
  if (index == chooseMaterial) {
    m_box->setCurrentIndex(m_last);
    return Q_EMIT wanted();
  }
  m_last = index;
  refresh();
  Q_EMIT edited();
}

void MeasuredMaterialRows::refresh() {
  for (widgets::NumberField* number : {m_noise, m_floor, m_misalignment}) number->setEnabled(choice() != Choice::none);
}

MeasuredMaterialRows::Choice MeasuredMaterialRows::choice() const { return Choice(m_box->currentIndex()); }

void MeasuredMaterialRows::choose(const QString& id, const QString& name) {
  m_box->setItemText(chosenMaterial, name);
  m_box->setItemData(chosenMaterial, id);
  hideItem(*m_box, chosenMaterial, false);
  m_last = chosenMaterial;
  m_box->setCurrentIndex(m_last);
  refresh();
}

QString MeasuredMaterialRows::chosenId() const { return m_box->itemData(chosenMaterial).toString(); }

acquisition::MeasurementNoise MeasuredMaterialRows::noise(std::uint64_t seed) const {
  return {.relative = m_noise->value(),
          .absolute = m_floor->value(),
          .misalignment = m_misalignment->value(),
          .seed = seed};
}

bool MeasuredMaterialRows::isNoisy() const {
  return m_noise->value() > 0 || m_floor->value() > 0 || m_misalignment->value() > 0;
}

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
      tr("Method that computes the whole material from the measured values; the ridge methods give an uncertainty"));
  const std::pair<QString, QString> methods[] = {
      {tr("Local ridge"), tr("Ridge regression over up to %1 components; each training material is weighted by how "
                             "well it agrees with the measured values")
                              .arg(study::defaultBasisComponents)},
      {tr("Ridge, automatic η"), tr("Tikhonov regularisation over up to %1 components, with the η that predicts each "
                                    "sample best from all others (leave-one-out)")
                                     .arg(study::defaultBasisComponents)},
      {tr("Ridge, published η = %1").arg(acquisition::publishedRidge),
       tr("Ridge with the published η, over as many components as with automatic η. The published η suits about "
          "400 training signals; with fewer, it smooths too much.")},
      {tr("Ridge, published equation"),
       tr("The published equation (Tongbuasirilai 2023, eq. 5.14): η = %1, as many components as samples, and the same "
          "noise in all samples")
           .arg(acquisition::publishedRidge)},
      {tr("Sparse"), tr("Few components, chosen by orthogonal matching pursuit; it gives no uncertainty")},
      {tr("Basis pursuit (ℓ1)"),
       tr("The coefficients with the smallest sum of absolute values; it gives no uncertainty")}};
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
  settings.materialClass = m_training->materialClass();
  settings.leaveOutReference = m_training->leavesMeasuredOut();
  settings.method = m_directions->method();
  settings.overAtoms = m_directions->isOverAtoms();
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
  if (index == basisPursuit) options.method = acquisition::ReconstructionMethod::basisPursuit;
  if (index == publishedRidge) options.ridge = acquisition::publishedRidge;
  options.components = study::defaultBasisComponents;
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
