// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_panel.h"

#include <QCoreApplication>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStandardPaths>
#include <QTabWidget>
#include <QVBoxLayout>
#include <cmath>

#include "app/gonio/acquisition/acquisition_charts.h"
#include "app/gonio/acquisition/acquisition_files.h"
#include "app/gonio/acquisition/factor_page.h"
#include "app/gonio/acquisition/reconstruction_page.h"
#include "app/gonio/acquisition/samples_page.h"

namespace gonio::app {

namespace {
constexpr int controlEms = 20;

}  // namespace

AcquisitionPanel::AcquisitionPanel(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_session(tasks),
      m_controls(new AcquisitionControls),
      m_source(new MeasuredMaterialSource(document, m_session, *m_controls)),
      m_files(new AcquisitionFiles(m_session, *m_controls, *m_source, this)),
      m_charts(new AcquisitionCharts(m_session, *m_controls)),
      m_samples(new SamplesPage(m_session, *m_controls, *m_files)),
      m_reconstruction(new ReconstructionPage(m_session, *m_controls)),
      m_curve(new ErrorCurvePage(m_session)),
      m_factors(new FactorPage(m_session, *m_controls, *m_files, tasks)),
      m_pages(new QTabWidget),
      m_start(new QPushButton),
      m_progress(new QProgressBar),
      m_status(new QLabel) {
  m_pages->addTab(m_samples, tr("Samples"));
  m_pages->addTab(m_reconstruction, tr("&Reconstruction"));
  m_pages->addTab(m_curve, tr("Errors"));
  m_pages->addTab(m_factors, tr("T&wo curves"));
  m_pages->setTabToolTip(factorPage,
                         tr("Measures two curves instead of chosen directions, and predicts the material from them"));
  m_pages->setDocumentMode(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(fontMetrics().height() / 2);
  m_start->setToolTip(tr("Chooses directions to measure with the settings above; press again to stop"));
  layout->addWidget(controlColumn(*m_controls, *m_start, *m_progress, *m_status, controlEms));
  layout->addWidget(m_charts, 3);
  layout->addWidget(m_pages, 2);
  connectSession();
  connectParts();
  m_session.setReconstruction(m_controls->reconstruction());
  refresh();
}

QSize AcquisitionPanel::sizeHint() const { return QSize(80, 24) * fontMetrics().height(); }

QWidget* controlColumn(QWidget& controls, QPushButton& start, QProgressBar& progress, QLabel& status, int ems) {
  auto* scroll = new QScrollArea;
  scroll->setFocusPolicy(Qt::NoFocus);  // what it holds has the focus
  scroll->setWidget(&controls);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* column = new QWidget;
  const QFontMetrics metrics = column->fontMetrics();
  start.setDefault(true);
  progress.setRange(0, 1000);
  progress.setTextVisible(false);
  progress.setFixedHeight(metrics.height() / 2);
  progress.setAccessibleName(QCoreApplication::translate("ControlColumn", "Progress"));
  QSizePolicy kept = progress.sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  progress.setSizePolicy(kept);
  status.setWordWrap(true);
  status.setTextFormat(Qt::PlainText);
  status.setAlignment(Qt::AlignTop | Qt::AlignLeft);
  status.setMinimumHeight(2 * metrics.lineSpacing() + 2);
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll, 1);
  for (QWidget* below : std::initializer_list<QWidget*>{&start, &progress, &status}) layout->addWidget(below);
  column->setFixedWidth(ems * metrics.height());
  return column;
}

void AcquisitionPanel::connectSession() {
  using Session = AcquisitionSession;
  connect(&m_session.referenceReader(), &ReferenceReader::changed, this, &AcquisitionPanel::showResultPage);
  connect(&m_session, &Session::resultChanged, this, &AcquisitionPanel::showResultPage);
  // After the pages, which connected themselves before.
  connect(&m_session.referenceReader(), &ReferenceReader::changed, this, &AcquisitionPanel::refresh);
  for (const auto signal : {&Session::directionsChanged, &Session::planChanged, &Session::valuesChanged,
                            &Session::resultChanged, &Session::curveChanged, &Session::progressed})
    connect(&m_session, signal, this, &AcquisitionPanel::refresh);
  connect(&m_session, &Session::failed, this, &AcquisitionPanel::failed);
  connect(m_controls, &AcquisitionControls::planSettingsEdited, this, &AcquisitionPanel::refresh);
  connect(m_controls, &AcquisitionControls::noiseEdited, this, [this] { m_session.simulate(m_controls->noise()); });
  connect(m_controls, &AcquisitionControls::reconstructionEdited, this,
          [this] { m_session.setReconstruction(m_controls->reconstruction()); });
}

void AcquisitionPanel::connectParts() {
  connect(&m_controls->measuredMaterial(), &MeasuredMaterialRows::wanted, this,
          &AcquisitionPanel::measuredMaterialRequested);
  connect(&m_session, &AcquisitionSession::materialMade, this, &AcquisitionPanel::materialMade);
  connect(m_files, &AcquisitionFiles::exported, this, &AcquisitionPanel::exported);
  connect(m_files, &AcquisitionFiles::failed, this, &AcquisitionPanel::failed);
  connect(m_charts, &AcquisitionCharts::currentChanged, this, &AcquisitionPanel::mark);
  connect(m_samples, &SamplesPage::currentChanged, this, &AcquisitionPanel::mark);
  connect(m_reconstruction, &ReconstructionPage::openRequested, this, &AcquisitionPanel::openResult);
  connect(m_factors, &FactorPage::openRequested, this, &AcquisitionPanel::openPrediction);
  connect(m_factors, &FactorPage::exported, this, &AcquisitionPanel::exported);
  connect(m_factors, &FactorPage::failed, this, &AcquisitionPanel::failed);
  // The charts show the directions of the other pages.
  connect(m_pages, &QTabWidget::currentChanged, this, [this](int page) { m_charts->setVisible(page != factorPage); });
  connect(m_pages, &QTabWidget::tabBarClicked, this, [this] { m_pageChosen = true; });
  connect(m_start, &QPushButton::clicked, this, &AcquisitionPanel::start);
}

QString AcquisitionPanel::status() const { return m_status->text(); }

bool AcquisitionPanel::isSettled() const {
  return !isVisible() || (!m_session.isBusy() && !m_session.referenceReader().isReading() && !m_session.isOpening() &&
                          !m_factors->isBusy());
}

void AcquisitionPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  m_source->takeOpenMaterial();
}

void AcquisitionPanel::measure(const QString& id) { m_source->choose(id); }

void AcquisitionPanel::start() {
  if (startCancels(m_session, *m_controls)) return m_session.cancel();
  m_source->takeOpenMaterial();
  m_pageChosen = false;
  m_pages->setCurrentIndex(samplesPage);
  m_session.plan(m_controls->planSettings());
}

void AcquisitionPanel::mark(int sample) {
  m_charts->setCurrent(sample);
  m_samples->setCurrent(sample);
}

void AcquisitionPanel::showResultPage() {
  if (m_session.result() && !m_pageChosen && m_pages->currentIndex() == samplesPage)
    m_pages->setCurrentIndex(reconstructionPage);
}

void AcquisitionPanel::refresh() {
  const bool busy = m_session.isBusy();
  m_start->setText(startCancels(m_session, *m_controls) ? tr("Cancel") : tr("&Start"));
  m_controls->setBusy(busy && !m_session.planner().hasPlan());
  m_progress->setVisible(busy);
  m_progress->setValue(int(std::lround(m_progress->maximum() * m_session.fraction())));
  m_status->setText(acquisitionStatus(m_session, *m_controls));
  m_charts->refresh();
  m_samples->refresh();
  m_reconstruction->refresh();
  m_curve->refresh();
}

void AcquisitionPanel::openResult() {
  if (!m_session.result()) return;
  m_source->fixOpenMaterial();
  m_session.open(reconstructionFolder());
}

void AcquisitionPanel::openPrediction() {
  if (!m_factors->result()) return;
  m_source->fixOpenMaterial();
  m_session.openTable(m_factors->result()->table, m_factors->resultName(), reconstructionFolder());
}

}  // namespace gonio::app

#include "moc_acquisition_panel.cpp"
