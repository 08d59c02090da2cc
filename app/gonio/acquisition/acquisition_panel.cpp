// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTableView>
#include <cmath>

#include "app/gonio/acquisition/acquisition_slice.h"
#include "widgets/acquisition/error_curve.h"
#include "widgets/acquisition/half_difference_chart.h"
#include "widgets/acquisition/hemisphere_chart.h"
#include "widgets/acquisition/reconstruction_view.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

namespace {
QString decibels(double value) { return QStringLiteral("%1 dB").arg(value, 0, 'f', 1); }
}  // namespace

AcquisitionPanel::AcquisitionPanel(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_session(tasks),
      m_controls(new AcquisitionControls),
      m_start(new QPushButton),
      m_open(new QPushButton(tr("Open as Mater&ial"))),
      m_copy(new QPushButton(tr("&Copy"))),
      m_save(new QPushButton(tr("Save Plan..."))),
      m_openPlan(new QPushButton(tr("Open Plan..."))),
      m_paste(new QPushButton(tr("Pas&te Values"))),
      m_read(new QPushButton(tr("&Open Values..."))),
      m_progress(new QProgressBar),
      m_status(new QLabel),
      m_numbers(new QLabel),
      m_hemisphere(new widgets::HemisphereChart),
      m_chart(new widgets::HalfDifferenceChart),
      m_slice(new QSlider(Qt::Horizontal)),
      m_sliceText(new QLabel),
      m_uncertainty(new QCheckBox(tr("Uncertaint&y"))),
      m_pages(new QTabWidget),
      m_table(new QTableView),
      m_view(new widgets::ReconstructionView),
      m_quality(new QComboBox),
      m_curve(new widgets::ErrorCurve) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(fontMetrics().height() / 2);
  layout->addWidget(buildControls());
  layout->addWidget(buildCharts(), 3);
  layout->addWidget(buildPages(), 2);
  connectSession();
  connectCharts();
  connectButtons();
  m_session.setReconstruction(m_controls->reconstruction());
  showDirections();
  showSlice();
  showResult();
  showCurve();
}

QString AcquisitionPanel::status() const { return m_status->text(); }
QString AcquisitionPanel::numbers() const { return m_numbers->text(); }

bool AcquisitionPanel::isSettled() const {
  return !isVisible() || (!m_session.isBusy() && !m_session.isReadingReference() && !m_session.isOpening());
}

void AcquisitionPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  takeOpenMaterial();
}

// --- What is measured

void AcquisitionPanel::takeOpenMaterial() {
  if (m_controls->subject() != AcquisitionControls::Subject::openMaterial || !isVisible()) return;
  const LoadedMaterialPtr material = m_document.material();
  const std::vector<editing::Edit> edits = m_document.edits();
  if (material == m_taken && edits == m_takenEdits && m_session.referenceName() == m_document.name()) return;
  m_taken = material;
  m_takenEdits = edits;
  if (!material) return m_session.clearReference();
  m_session.setReference(QString::fromStdString(material->material.source.path.string()), m_document.name(),
                         [table = material->table, edits](const TaskControl& control) {
                           return editing::bakeEdits(table, edits, control);
                         });
}

void AcquisitionPanel::subjectEdited() {
  m_taken.reset();
  if (m_controls->subject() == AcquisitionControls::Subject::none) m_session.clearReference();
  if (m_controls->subject() == AcquisitionControls::Subject::openMaterial) takeOpenMaterial();
  if (m_controls->subject() == AcquisitionControls::Subject::chosen)
    m_session.setReference(m_controls->subjectBox().currentData().toString());
}

void AcquisitionPanel::measure(const QString& id) {
  m_session.setReference(id);
  m_controls->setChosenSubject(m_session.referenceName());
  m_controls->subjectBox().setItemData(m_controls->subjectBox().currentIndex(), id);
}

/// With other settings than those at work it starts anew instead.
bool AcquisitionPanel::startCancels() const {
  return m_session.isBusy() && (!m_session.hasPlan() || m_session.settings() == m_controls->planSettings());
}

void AcquisitionPanel::start() {
  if (startCancels()) return m_session.cancel();
  takeOpenMaterial();
  m_pageChosen = false;
  m_pages->setCurrentIndex(samplesPage);
  m_session.plan(m_controls->planSettings());
}

// --- What is shown

void AcquisitionPanel::mark(int sample) {
  m_hemisphere->setCurrent(sample);
  m_chart->setCurrent(sample);
  if (m_table->currentIndex().row() == sample) return;
  m_table->setCurrentIndex(sample < 0 ? QModelIndex() : m_model.index(sample, 0));
}

void AcquisitionPanel::showDirections() {
  const std::vector<DirectionPair> directions = m_session.directions();
  m_hemisphere->setSamples(directions);
  m_chart->setSamples(directions);
  if (m_session.hasPlan())
    m_model.setPlan(m_session.samplingPlan());
  else
    m_model.setDirections(directions);
  m_model.setValues(m_session.values());
  refresh();
}

void AcquisitionPanel::showSlice() {
  const auto& basis = m_session.basis();
  const HalfDifferenceGrid grid = basis ? basis->mapping.grid : HalfDifferenceGrid();
  m_slice->setMaximum(grid.phiDCount - 1);
  const AcquisitionResultPtr& result = m_session.result();
  const bool known = result && basis && !result->reconstruction->deviation.empty();
  m_uncertainty->setEnabled(known);
  std::span<const float> deviations;
  if (known && m_uncertainty->isChecked()) deviations = result->reconstruction->deviation;
  const acquisition::MeasurableDirections measurable = m_controls->planSettings().measurable;
  m_hemisphere->setLargestPolarAngle(measurable.largestPolarAngle);
  m_chart->setSlice(sliceAt(m_slice->value(), grid, measurable, basis ? &basis->mapping : nullptr, deviations));
  if (known) m_chart->setRange(result->deviationRange);
  m_sliceText->setText(tr("%1°").arg(degrees(m_chart->slice().phiD), 0, 'f', 0));
}

void AcquisitionPanel::showReference() {
  if (m_controls->subject() == AcquisitionControls::Subject::chosen && !m_session.referenceName().isEmpty())
    m_controls->subjectBox().setItemText(int(AcquisitionControls::Subject::chosen), m_session.referenceName());
  m_controls->setMeasuredId(m_session.referenceId());
  showResult();
}

void AcquisitionPanel::showResult() {
  const AcquisitionReferencePtr& reference = m_session.reference();
  const AcquisitionResultPtr& result = m_session.result();
  widgets::ReconstructionView::Content content;
  if (reference) {
    content.reference = reference->picture;
    content.referenceName = reference->name;
  }
  m_numbers->clear();
  if (result) {
    content.reconstruction = result->picture;
    content.errorMap = result->errorMap;
    content.errorRange = result->errorRange;
    QStringList facts;
    if (result->error)
      facts << tr("rendered SNR %1").arg(decibels(result->error->renderedSnr))
            << tr("log error %1").arg(widgets::formatNumber(result->error->logError));
    const acquisition::Reconstruction& made = *result->reconstruction;
    facts << tr("%n components", nullptr, made.components);
    if (made.ridge > 0) facts << tr("η = %1").arg(widgets::formatNumber(made.ridge));
    if (std::isfinite(made.leaveOneOutError))
      facts << tr("leave-one-out error of ln ρ %1").arg(widgets::formatNumber(made.leaveOneOutError));
    m_numbers->setText(facts.join(QStringLiteral(" · ")));
    if (!m_pageChosen && m_pages->currentIndex() == samplesPage) m_pages->setCurrentIndex(reconstructionPage);
  }
  m_view->setContent(content);
  showSlice();
  refresh();
}

void AcquisitionPanel::showCurve() {
  const bool snr = m_quality->currentIndex() == 0;
  std::vector<widgets::ErrorCurve::Point> points;
  for (const AcquisitionSession::CurvePoint& point : m_session.curve())
    points.push_back({point.samples, snr ? point.error.renderedSnr : point.error.logError});
  m_curve->setPoints(std::move(points), snr ? tr("rendered SNR [dB]") : tr("log error"), !snr);
  m_curve->setMarked(int(m_session.samplingPlan().samples.size()));
  refresh();
}

QString AcquisitionPanel::nextStep() const {
  using Step = AcquisitionSession::Step;
  switch (m_session.step()) {
    case Step::learning:
      return tr("Learning the training set...");
    case Step::choosing:
      return tr("Choosing directions: %1 of %2").arg(m_hemisphere->samples().size()).arg(m_session.settings().samples);
    case Step::reconstructing:
      return tr("Reconstructing...");
    case Step::measuringCurve:
      return tr("Measuring the error over m...");
    case Step::idle:
      break;
  }
  if (!m_session.hasPlan()) return tr("Start chooses where to measure.");
  if (m_session.settings() != m_controls->planSettings()) return tr("The settings have changed: start anew.");
  if (!m_session.selection().warning.empty()) return QString::fromStdString(m_session.selection().warning);
  if (m_session.isReadingReference()) return tr("Preparing %1...").arg(m_session.referenceName());
  if (m_session.values().rgb.empty()) return tr("Save the plan, measure, then paste or open the values.");
  if (m_session.isReferenceLearned() && m_session.result())
    return tr("%1 is in the training set: the error is too small. Start anew to leave it out.")
        .arg(m_session.referenceName());
  if (!m_session.result()) return tr("Stopped before the material was reconstructed: start anew.");
  return tr("Values: %1").arg(m_session.valuesName());
}

void AcquisitionPanel::refresh() {
  const bool busy = m_session.isBusy(), planned = m_session.hasPlan();
  m_start->setText(startCancels() ? tr("Cancel") : tr("&Start"));
  m_controls->setBusy(busy && !planned);
  m_progress->setVisible(busy);
  m_progress->setValue(int(std::lround(m_progress->maximum() * m_session.share())));
  m_status->setText(nextStep());
  for (QPushButton* button : {m_copy, m_save, m_paste, m_read}) button->setEnabled(planned);
  m_openPlan->setEnabled(!startCancels());
  m_open->setEnabled(m_session.result() && !m_session.isOpening());
  const QString empty = busy ? QString() : tr("Start chooses directions here.");
  m_hemisphere->setHint(empty);
  m_chart->setHint(empty);
  const QString values = !planned ? tr("Start chooses directions; the material is reconstructed from its values there.")
                         : busy   ? tr("Working...")
                         : m_session.values().rgb.empty()
                             ? tr("Paste or open the values that were measured at the samples.")
                             : nextStep();
  m_view->setHint(values);
  m_curve->setHint(!m_session.reference() ? tr("The error needs a material to compare with: choose one to measure.")
                   : busy                 ? tr("Working...")
                                          : tr("Start measures the error over ever more of the samples."));
}

void AcquisitionPanel::openResult() {
  if (!m_session.result()) return;
  // What is opened is not what is measured from now on.
  if (m_controls->subject() == AcquisitionControls::Subject::openMaterial && m_session.reference()) {
    m_controls->setChosenSubject(m_session.referenceName());
    m_controls->subjectBox().setItemData(m_controls->subjectBox().currentIndex(), m_session.referenceId());
  }
  m_session.open(m_document,
                 QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/acquired"));
}

}  // namespace gonio::app

#include "moc_acquisition_panel.cpp"
