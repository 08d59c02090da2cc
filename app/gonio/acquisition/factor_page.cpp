// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/factor_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "app/gonio/acquisition/acquisition_files.h"
#include "widgets/acquisition/reconstruction_view.h"
#include "widgets/inputs/flow_layout.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

namespace {

const QString factorKey = QStringLiteral("factor measurement");
constexpr int minReadings = 5, maxReadings = 500;
constexpr double maxFixedAngle = radians(89);

struct AxesText {
  QString name, explanation, angle, distance;
};

/// In the order of acquisition::FactorAxes.
std::array<AxesText, 5> axesTexts() {
  return {{{FactorPage::tr("Projected deviation (θR, |Δp|)"),
            FactorPage::tr("The axes of the published method (Tongbuasirilai et al. 2017, Efficient BRDF Sampling "
                           "Using Projected Deviation Vector Parameterization); θR is the polar angle of the mirror "
                           "direction, equal to that of the viewer"),
            FactorPage::tr("θR [°]"), FactorPage::tr("|Δp|")},
           {FactorPage::tr("Symmetric deviation (θd, |Δp|)"),
            FactorPage::tr(
                "Readings as for projected deviation, but the prediction is reciprocal: exchanging light and viewer "
                "does not change it"),
            FactorPage::tr("θd [°]"), FactorPage::tr("|Δp|")},
           {FactorPage::tr("Half-difference (θd, θh)"),
            FactorPage::tr("Curves over difference angle θd and half angle θh; the prediction is reciprocal"),
            FactorPage::tr("θd [°]"), FactorPage::tr("θh [°]")},
           {FactorPage::tr("Half-out (θo, θh)"),
            FactorPage::tr("Curves over the angle θo of the viewer and the half angle θh"), FactorPage::tr("θo [°]"),
            FactorPage::tr("θh [°]")},
           {FactorPage::tr("Adaptive (all readings)"),
            FactorPage::tr("The same number of readings, a third to a half of them at further angles; the material is "
                           "fitted to all of them together, and the readings choose the distance between |Δp| and θh"),
            FactorPage::tr("θd [°]"), FactorPage::tr("|Δp|")}}};
}

QWidget* labelled(const QString& text, QWidget* field) {
  auto* widget = new QWidget;
  auto* label = new QLabel(text);
  label->setBuddy(field);
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(label);
  row->addWidget(field);
  return widget;
}

}  // namespace

FactorPage::FactorPage(const AcquisitionSession& session, const AcquisitionControls& controls, AcquisitionFiles& files,
                       BackgroundTasks& tasks)
    : m_session(session),
      m_controls(controls),
      m_files(files),
      m_tasks(tasks),
      m_axes(new QComboBox),
      m_bound(new QCheckBox(tr("&Limit prediction"))),
      m_curves(new widgets::FactorCurves),
      m_view(new widgets::ReconstructionView),
      m_numbers(new QLabel),
      m_warnings(new QLabel),
      m_open(new QPushButton(tr("Open as Mater&ial"))),
      m_openReadings(new QPushButton(tr("Open Readings..."))),
      m_saveReadings(new QPushButton(tr("Save Readings..."))),
      m_simulate(new QPushButton(tr("Simulate Readings"))) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addLayout(buildSettings());
  layout->addLayout(buildResult(), 1);
  connectParts();
  showResult();
}

QLayout* FactorPage::buildSettings() {
  for (const AxesText& axes : axesTexts()) {
    m_axes->addItem(axes.name);
    m_axes->setItemData(m_axes->count() - 1, axes.explanation, Qt::ToolTipRole);
  }
  m_axes->setToolTip(
      tr("The two curves: the first over an angle, in the mirror direction; the second over the distance from the "
         "mirror direction.\n"
         "Adaptive axes fit the material to all readings. With other axes it is predicted as a product of the curves: "
         "ln(1 + ρ) = F1(angle) F2(distance)."));
  m_axes->setCurrentIndex(int(acquisition::FactorAxes::adaptive));
  m_fixedAngle = rowField(tr("Fixed angle"), {}, 0, maxFixedAngle, radians(1), QStringLiteral("°"), degrees(1));
  m_fixedAngle->setValue(acquisition::FactorPlanOptions().fixedAngle);
  m_readings = rowField(tr("Readings per curve"), {}, minReadings, maxReadings, 1, {});
  m_readings->setValue(acquisition::FactorPlanOptions().angles);
  m_bound->setChecked(true);
  m_bound->setToolTip(
      tr("Limits the product of the curves in two ways. It is at most the larger of two readings: the one at the same "
         "angle and the one at the same distance.\n"
         "It is also at most the prediction with light and viewer exchanged. If off, the published equation is used "
         "unchanged.\n"
         "With adaptive axes, only the first limit applies."));
  m_openReadings->setToolTip(
      tr("Opens measured or saved readings of both curves and predicts the material from them.\n"
         "CSV with the columns index, curve (along, across or further), theta_i, phi_i, theta_o, phi_o in degrees, and "
         "r, g, b in "
         "1/sr"));
  m_open->setToolTip(
      tr("Opens the predicted material as a material that can be edited, saved and exported.\n"
         "Undo restores the previous material."));
  auto* row = new widgets::FlowLayout;
  for (QWidget* part : {labelled(tr("A&xes"), m_axes), labelled(tr("Fixed an&gle"), m_fixedAngle),
                        labelled(tr("Readin&gs per curve"), m_readings), static_cast<QWidget*>(m_bound),
                        static_cast<QWidget*>(m_openReadings), static_cast<QWidget*>(m_saveReadings),
                        static_cast<QWidget*>(m_simulate), static_cast<QWidget*>(m_open)})
    row->addWidget(part);
  return row;
}

QLayout* FactorPage::buildResult() {
  m_numbers->setObjectName(QStringLiteral("numbers"));
  m_warnings->setObjectName(QStringLiteral("warnings"));
  for (QLabel* label : {m_numbers, m_warnings}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  auto* side = new QVBoxLayout;
  side->addWidget(m_view, 1);
  side->addWidget(m_numbers);
  side->addWidget(m_warnings);
  auto* row = new QHBoxLayout;
  row->addWidget(m_curves, 1);
  row->addLayout(side, 1);
  return row;
}

void FactorPage::connectParts() {
  connect(m_axes, &QComboBox::activated, this, &FactorPage::changeAxes);
  connect(m_bound, &QCheckBox::clicked, this, &FactorPage::measure);
  for (widgets::NumberField* field : {m_fixedAngle, m_readings})
    connect(field, &widgets::NumberField::valueEdited, this, &FactorPage::measure);
  connect(m_open, &QPushButton::clicked, this, &FactorPage::openRequested);
  connect(m_openReadings, &QPushButton::clicked, this, [this] {
    connect(m_files.openDialog(tr("Open Readings"), tr("Readings (*.csv *.txt);;All files (*)")),
            &QFileDialog::fileSelected, this, &FactorPage::openReadings);
  });
  connect(m_saveReadings, &QPushButton::clicked, this, [this] {
    connect(m_files.saveDialog(tr("Save Readings"), tr("Readings (*.csv)"),
                               tr("%1 readings").arg(QString(m_resultOf).replace('/', '-'))),
            &QFileDialog::fileSelected, this, &FactorPage::saveReadings);
  });
  connect(m_simulate, &QPushButton::clicked, this, &FactorPage::simulate);
  connect(&m_controls, &AcquisitionControls::noiseEdited, this, [this] {
    if (!m_opened) measure();
  });
  connect(&m_session.referenceReader(), &ReferenceReader::changed, this, &FactorPage::measure);
}

FactorSettings FactorPage::settings() const {
  FactorSettings settings{.plan = {}, .bound = acquisition::FactorBound::readings, .noise = m_controls.noise()};
  settings.plan.axes = acquisition::FactorAxes(m_axes->currentIndex());
  settings.plan.fixedAngle = m_fixedAngle->value();
  settings.plan.angles = settings.plan.distances = int(std::lround(m_readings->value()));
  if (!m_bound->isChecked()) settings.bound = acquisition::FactorBound::none;
  return settings;
}

QString FactorPage::resultName() const { return tr("%1 from two curves").arg(m_resultOf); }
bool FactorPage::isBusy() const { return m_tasks.isRunning(factorKey); }

void FactorPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!m_result && !isBusy()) measure();
}

void FactorPage::openReadings(const QString& path) {
  try {
    m_opened = readFactorReadings(path, settings().plan.axes);
  } catch (const Error& error) {
    return Q_EMIT failed(tr("Cannot open the readings"), QString::fromUtf8(error.what()));
  }
  m_axes->setCurrentIndex(int(m_opened->curves.axes));
  m_fixedAngle->setValue(m_opened->curves.fixedAngle);
  const bool isAdaptive = m_opened->curves.axes == acquisition::FactorAxes::adaptive;
  m_readings->setValue(isAdaptive ? std::round(double(m_opened->readings.plan.curves.size()) / 2)
                                  : acquisition::plannedReadings(m_opened->curves.angles));
  measure();
}

void FactorPage::saveReadings(const QString& path) {
  if (!m_result) return;
  try {
    acquisition::writeFactorReadings(m_result->readings.plan, m_result->readings.values, path.toStdString());
    Q_EMIT exported(path);
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot save the readings"), QString::fromUtf8(error.what()));
  }
}

void FactorPage::simulate() {
  m_opened.reset();
  // A file may have other numbers than a simulation.
  m_fixedAngle->setValue(std::min(m_fixedAngle->value(), maxFixedAngle));
  m_readings->setValue(std::clamp(m_readings->value(), double(minReadings), double(maxReadings)));
  measure();
}

void FactorPage::changeAxes() {
  try {
    if (m_opened) m_opened = withAxes(*m_opened, settings().plan.axes);
  } catch (const Error& error) {
    m_axes->setCurrentIndex(int(m_opened->curves.axes));
    return Q_EMIT failed(tr("Cannot use these axes"), QString::fromUtf8(error.what()));
  }
  measure();
}

void FactorPage::measure() {
  m_tasks.drop(factorKey);
  m_result.reset();
  const ReferenceReader& reader = m_session.referenceReader();
  const AcquisitionReferencePtr reference = reader.reference();
  if (isVisible() && (reference || (m_opened && !reader.isReading()))) {
    const QString name = m_opened ? QFileInfo(m_opened->path).completeBaseName() : reference->name;
    m_tasks.run<FactorResultPtr>(
        {m_opened ? tr("Predicting from two curves") : tr("Measuring two curves"), factorKey},
        [settings = settings(), opened = m_opened, reference](const TaskControl& control) {
          return opened ? predictFromReadings(opened->readings, settings.bound, reference, control)
                        : predictFromSimulation(settings, reference, control);
        },
        [this, name](const FactorResultPtr& result) {
          m_result = result;
          m_resultOf = name;
          showResult();
        },
        [this](const QString& error) { Q_EMIT failed(tr("Cannot predict the material from two curves"), error); });
  }
  showResult();
}

widgets::FactorCurves::Content FactorPage::shownCurves() const {
  if (!m_result) return {};
  const acquisition::FactorMeasurement& read = m_result->curves;
  const AxesText texts = axesTexts()[std::size_t(read.axes)];
  widgets::FactorCurves::Content curves{{}, {}, read.along, read.across, texts.angle, texts.distance};
  for (const double angle : read.angles) curves.angles.push_back(degrees(angle));
  for (const double distance : read.distances)
    curves.distances.push_back(acquisition::isDeviation(read.axes) ? distance : degrees(distance));
  // The curve "along" of an unscaled channel is 1, not its readings.
  for (std::size_t channel = 0; channel < 3; ++channel)
    if (read.unscaled[channel]) curves.along[channel].clear();
  return curves;
}

QStringList FactorPage::facts() const {
  if (!m_result) return {};
  QStringList texts;
  if (m_result->error)
    texts << tr("rendered SNR %1 dB").arg(m_result->error->renderedSnr, 0, 'f', 1)
          << tr("log error %1").arg(widgets::formatNumber(m_result->error->logError));
  texts << (m_opened ? tr("%1 + %2 readings from %3") : tr("%1 + %2 readings"))
               .arg(m_result->curves.angles.size())
               .arg(m_result->curves.distances.size());
  if (m_opened) texts.back() = texts.back().arg(m_opened->name());
  if (const auto further = std::ranges::count(m_result->readings.plan.curves, acquisition::FactorCurve::further);
      further > 0 && m_result->curves.axes == acquisition::FactorAxes::adaptive)
    texts << tr("%1 at further angles").arg(further);
  if (const int blocked = m_result->readings.plan.blocked; blocked > 0)
    texts << tr("%1 left out (unreachable by the rig)").arg(blocked);
  return texts;
}

void FactorPage::showResult() {
  widgets::ReconstructionView::Content pictures;
  QStringList warnings;
  if (const AcquisitionReferencePtr& reference = m_session.referenceReader().reference()) {
    pictures.reference = reference->picture;
    pictures.referenceName = widgets::spacedName(reference->name);
  }
  if (m_result) {
    pictures.reconstruction = m_result->picture;
    pictures.errorMap = m_result->errorMap;
    pictures.errorRange = m_result->errorRange;
    for (const std::string& warning : m_result->support.warnings)
      warnings << QStringLiteral("⚠ ") + QString::fromStdString(warning);
  }
  m_curves->setContent(shownCurves());
  m_view->setContent(pictures);
  m_numbers->setText(facts().join(QStringLiteral(" · ")));
  m_warnings->setText(warnings.join('\n'));
  m_warnings->setVisible(!warnings.isEmpty());
  const bool isWorking = isBusy() || m_session.referenceReader().isReading();
  const QString hint = isWorking ? tr("Working...") : tr("Choose a material to measure, or open readings.");
  m_curves->setHint(hint);
  m_view->setHint(hint);
  refreshControls();
}

void FactorPage::refreshControls() {
  m_open->setEnabled(m_result && !m_session.isOpening());
  m_saveReadings->setEnabled(m_result != nullptr);
  m_saveReadings->setToolTip(m_result ? tr("Saves the directions and the readings of both curves as CSV, which "
                                           "goniotool measure --factors --values reads")
                                      : tr("Available when there are readings of both curves"));
  m_simulate->setEnabled(m_opened.has_value());
  m_simulate->setToolTip(
      m_opened ? tr("Replaces the readings from %1 by simulated ones of the material chosen under Measure")
                     .arg(m_opened->name())
               : tr("Available when the readings are from a file"));
  const QString ofFile =
      m_opened ? tr("\nDetermined by the readings of %1; press Simulate Readings to change it").arg(m_opened->name())
               : QString();
  m_fixedAngle->setToolTip(
      tr("Value of the first axis (θR, θd or θo) at which the second curve, over the distance from "
         "the mirror direction, is measured") +
      ofFile);
  m_readings->setToolTip(
      tr("Number of readings of each of the two curves. With adaptive axes, twice this number is distributed over the "
         "two curves and further angles.") +
      ofFile);
  for (widgets::NumberField* field : {m_fixedAngle, m_readings}) field->setEnabled(!m_opened);
}

}  // namespace gonio::app

#include "moc_factor_page.cpp"
