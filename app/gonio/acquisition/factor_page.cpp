// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/factor_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/gonio/acquisition/control_rows.h"
#include "widgets/acquisition/factor_curves.h"
#include "widgets/acquisition/reconstruction_view.h"
#include "widgets/inputs/flow_layout.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

namespace {

const QString factorKey = QStringLiteral("factor measurement");
constexpr int leastReadings = 5, mostReadings = 500;

struct AxesText {
  QString name, explanation, angle, distance;
};

/// In the order of acquisition::FactorAxes.
std::array<AxesText, 4> axesTexts() {
  return {{{FactorPage::tr("Projected deviation (θR, |Δp|)"),
            FactorPage::tr("The published axes (Tongbuasirilai et al. 2017); θR is the polar angle of the mirror "
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
            FactorPage::tr("θh [°]")}}};
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

FactorPage::FactorPage(const AcquisitionSession& session, const AcquisitionControls& controls, BackgroundTasks& tasks)
    : m_session(session),
      m_controls(controls),
      m_tasks(tasks),
      m_axes(new QComboBox),
      m_bound(new QCheckBox(tr("&Limit prediction"))),
      m_curves(new widgets::FactorCurves),
      m_view(new widgets::ReconstructionView),
      m_numbers(new QLabel),
      m_warnings(new QLabel),
      m_open(new QPushButton(tr("Open as Mater&ial"))) {
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
      tr("Angle and distance from the mirror direction over which the two curves run.\n"
         "The material is predicted as a product of the curves: ln(1 + ρ) = F1(angle) F2(distance)."));
  m_axes->setCurrentIndex(int(acquisition::FactorAxes::symmetricDeviation));
  m_fixedAngle =
      rowField(tr("Fixed angle"),
               tr("Value of the first axis (θR, θd or θo) at which the second curve, over the distance from the mirror "
                  "direction, is measured"),
               0, radians(89), radians(1), QStringLiteral("°"), degrees(1));
  m_fixedAngle->setValue(acquisition::FactorPlanOptions().fixedAngle);
  m_readings = rowField(tr("Readings per curve"), tr("Number of readings of each of the two curves"), leastReadings,
                        mostReadings, 1, {});
  m_readings->setValue(acquisition::FactorPlanOptions().angles);
  m_bound->setChecked(true);
  m_bound->setToolTip(tr(
      "Limits the prediction to the larger of the two nearest readings (at the same angle and at the same distance),\n"
      "and to the prediction with light and viewer exchanged. If off, the published equation is used unchanged."));
  m_open->setToolTip(
      tr("Opens the predicted material as a material that can be edited, saved and exported.\n"
         "Undo restores the previous material."));
  auto* row = new widgets::FlowLayout;
  for (QWidget* part :
       {labelled(tr("A&xes"), m_axes), labelled(tr("Fixed an&gle"), m_fixedAngle),
        labelled(tr("Readin&gs per curve"), m_readings), static_cast<QWidget*>(m_bound), static_cast<QWidget*>(m_open)})
    row->addWidget(part);
  return row;
}

QLayout* FactorPage::buildResult() {
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
  connect(m_axes, &QComboBox::activated, this, &FactorPage::measure);
  connect(m_bound, &QCheckBox::clicked, this, &FactorPage::measure);
  for (widgets::NumberField* field : {m_fixedAngle, m_readings})
    connect(field, &widgets::NumberField::valueEdited, this, &FactorPage::measure);
  connect(m_open, &QPushButton::clicked, this, &FactorPage::openRequested);
  connect(&m_controls, &AcquisitionControls::noiseEdited, this, &FactorPage::measure);
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
QString FactorPage::numbers() const { return m_numbers->text(); }
QString FactorPage::warnings() const { return m_warnings->text(); }

void FactorPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!m_result && !isBusy()) measure();
}

void FactorPage::measure() {
  m_tasks.drop(factorKey);
  m_result.reset();
  const AcquisitionReferencePtr reference = m_session.referenceReader().reference();
  if (isVisible() && reference) {
    m_tasks.run<FactorResultPtr>(
        {tr("Measuring two curves"), factorKey},
        [settings = settings(), reference](const TaskControl& control) {
          return measureFactors(settings, reference, control);
        },
        [this, name = reference->name](const FactorResultPtr& result) {
          m_result = result;
          m_resultOf = name;
          showResult();
        },
        [this](const QString& error) { Q_EMIT failed(tr("Cannot predict the material from two curves"), error); });
  }
  showResult();
}

void FactorPage::showResult() {
  widgets::FactorCurves::Content curves;
  widgets::ReconstructionView::Content pictures;
  QStringList facts, warnings;
  if (const AcquisitionReferencePtr& reference = m_session.referenceReader().reference()) {
    pictures.reference = reference->picture;
    pictures.referenceName = reference->name;
  }
  if (m_result) {
    const acquisition::FactorMeasurement& read = m_result->curves;
    const AxesText texts = axesTexts()[std::size_t(read.axes)];
    curves = {{}, {}, read.along, read.across, texts.angle, texts.distance};
    for (const double angle : read.angles) curves.angles.push_back(degrees(angle));
    for (const double distance : read.distances)
      curves.distances.push_back(acquisition::isDeviation(read.axes) ? distance : degrees(distance));
    // The curve "along" of an unscaled channel is 1, not its readings.
    for (std::size_t channel = 0; channel < 3; ++channel)
      if (read.unscaled[channel]) curves.along[channel].clear();
    pictures.reconstruction = m_result->picture;
    pictures.errorMap = m_result->errorMap;
    pictures.errorRange = m_result->errorRange;
    if (m_result->error)
      facts << tr("rendered SNR %1 dB").arg(m_result->error->renderedSnr, 0, 'f', 1)
            << tr("log error %1").arg(widgets::formatNumber(m_result->error->logError));
    facts << tr("%1 + %2 readings").arg(read.angles.size()).arg(read.distances.size());
    if (m_result->blocked > 0) facts << tr("%1 obstructed").arg(m_result->blocked);
    for (const std::string& warning : m_result->support.warnings)
      warnings << QStringLiteral("⚠ ") + QString::fromStdString(warning);
  }
  m_curves->setContent(std::move(curves));
  m_view->setContent(pictures);
  m_numbers->setText(facts.join(QStringLiteral(" · ")));
  m_warnings->setText(warnings.join('\n'));
  m_warnings->setVisible(!warnings.isEmpty());
  m_open->setEnabled(m_result && !m_session.isOpening());
  const QString hint = isBusy() ? tr("Working...") : tr("Choose a material to measure.");
  m_curves->setHint(hint);
  m_view->setHint(hint);
}

}  // namespace gonio::app

#include "moc_factor_page.cpp"
