// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/reconstruction_page.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/acquisition/error_curve.h"
#include "widgets/acquisition/reconstruction_view.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

ErrorCurvePage::ErrorCurvePage(const AcquisitionSession& session)
    : m_session(session), m_quality(new QComboBox), m_curve(new widgets::ErrorCurve) {
  m_quality->addItems({tr("rendered SNR"), tr("log error")});
  m_quality->setToolTip(tr("Error of the reconstruction from the first m samples against the measured material"));
  auto* label = new QLabel(tr("Sho&w"));
  label->setBuddy(m_quality);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(m_quality);
  row->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addLayout(row);
  layout->addWidget(m_curve, 1);
  connect(m_quality, &QComboBox::currentIndexChanged, this, &ErrorCurvePage::showCurve);
  for (const auto signal : {&AcquisitionSession::planChanged, &AcquisitionSession::curveChanged})
    connect(&m_session, signal, this, &ErrorCurvePage::showCurve);
  showCurve();
}

void ErrorCurvePage::showCurve() {
  const bool snr = m_quality->currentIndex() == 0;
  std::vector<widgets::ErrorCurve::Point> points;
  for (const AcquisitionSession::CurvePoint& point : m_session.curve())
    points.push_back({point.samples, snr ? point.error.renderedSnr : point.error.logError});
  m_curve->setPoints(std::move(points), snr ? tr("rendered SNR [dB]") : tr("log error"), !snr);
  m_curve->setMarked(int(m_session.planner().samplingPlan().samples.size()));
}

void ErrorCurvePage::refresh() {
  m_curve->setHint(!m_session.referenceReader().reference()
                       ? tr("No reference: choose a material under Measure to see the error of its reconstruction.")
                   : m_session.isBusy() ? tr("Working...")
                                        : tr("Press Start to measure the error for increasing numbers of samples."));
}

namespace {
struct AcquisitionStatusText {
  Q_DECLARE_TR_FUNCTIONS(AcquisitionStatus)
};
}  // namespace

bool startCancels(const AcquisitionSession& session, const AcquisitionControls& controls) {
  const AcquisitionPlanner& planner = session.planner();
  return session.isBusy() && (!planner.hasPlan() || planner.settings() == controls.planSettings());
}

QString acquisitionStatus(const AcquisitionSession& session, const AcquisitionControls& controls) {
  const AcquisitionPlanner& planner = session.planner();
  using Text = AcquisitionStatusText;
  using Step = AcquisitionSession::Step;
  switch (session.step()) {
    case Step::learning:
      return Text::tr("Learning from the training set...");
    case Step::choosing:
      return Text::tr("Choosing directions: %1 of %2").arg(planner.directions().size()).arg(planner.settings().samples);
    case Step::reconstructing:
      return Text::tr("Reconstructing...");
    case Step::measuringCurve:
      return Text::tr("Computing the error curve...");
    case Step::idle:
      break;
  }
  if (!planner.hasPlan()) return Text::tr("Press Start to choose directions.");
  if (planner.settings() != controls.planSettings()) return Text::tr("The settings have changed. Press Start again.");
  if (!planner.selection().warning.empty()) return QString::fromStdString(planner.selection().warning);
  if (session.referenceReader().isReading()) return Text::tr("Preparing %1...").arg(session.referenceReader().name());
  if (session.values().rgb.empty()) return Text::tr("Save the plan, measure, then paste or open the values.");
  if (session.isReferenceLearned() && session.result())
    return Text::tr(
               "%1 is in the training set, so the error is lower than for a new material. To exclude it, tick "
               "\"Exclude the measured material\" and press Start.")
        .arg(session.referenceReader().name());
  if (!session.result()) return Text::tr("Stopped before the material was reconstructed. Press Start to try again.");
  return Text::tr("Values: %1").arg(session.valuesName());
}

ReconstructionPage::ReconstructionPage(const AcquisitionSession& session, const AcquisitionControls& controls)
    : m_session(session),
      m_controls(controls),
      m_view(new widgets::ReconstructionView),
      m_numbers(new QLabel),
      m_open(new QPushButton(tr("Open as Mater&ial"))) {
  m_numbers->setObjectName(QStringLiteral("numbers"));
  m_numbers->setWordWrap(true);
  m_numbers->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_open->setToolTip(
      tr("Opens the reconstruction as a material that can be edited, saved and exported.\nIts table is stored in "
         "Gonio's data folder. Undo restores the previous material."));
  auto* row = new QHBoxLayout;
  row->addWidget(m_numbers, 1);
  row->addWidget(m_open, 0, Qt::AlignTop);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addWidget(m_view, 1);
  layout->addLayout(row);
  connect(m_open, &QPushButton::clicked, this, &ReconstructionPage::openRequested);
  connect(&m_session.referenceReader(), &ReferenceReader::changed, this, &ReconstructionPage::showResult);
  connect(&m_session, &AcquisitionSession::resultChanged, this, &ReconstructionPage::showResult);
  showResult();
}

void ReconstructionPage::showResult() {
  widgets::ReconstructionView::Content content;
  if (const AcquisitionReferencePtr& reference = m_session.referenceReader().reference()) {
    content.reference = reference->picture;
    content.referenceName = widgets::spacedName(reference->name);
  }
  QStringList facts;
  if (const AcquisitionResultPtr& result = m_session.result()) {
    content.reconstruction = result->picture;
    content.errorMap = result->errorMap;
    content.errorRange = result->errorRange;
    if (result->error)
      facts << tr("rendered SNR %1 dB").arg(result->error->renderedSnr, 0, 'f', 1)
            << tr("log error %1").arg(widgets::formatNumber(result->error->logError));
    const acquisition::Reconstruction& made = *result->reconstruction;
    facts << tr("components: %n", nullptr, made.components);
    if (made.ridge > 0) facts << tr("η = %1").arg(widgets::formatNumber(made.ridge));
    if (std::isfinite(made.leaveOneOutError))
      facts << tr("leave-one-out error of a mapped value: %1").arg(widgets::formatNumber(made.leaveOneOutError));
  }
  m_numbers->setToolTip(m_session.result() ? tr("Assumed: %1")
                                                 .arg(QString::fromUtf8(acquisition::assumedOrders.data(),
                                                                        qsizetype(acquisition::assumedOrders.size())))
                                           : QString());
  m_numbers->setText(facts.join(QStringLiteral(" · ")));
  m_view->setContent(content);
}

void ReconstructionPage::refresh() {
  m_open->setEnabled(m_session.result() && !m_session.isOpening());
  m_view->setHint(m_session.isBusy() ? tr("Working...")
                  : !m_session.planner().hasPlan()
                      ? tr("Press Start to choose directions and to reconstruct the material from its values there.")
                  : m_session.values().rgb.empty() ? tr("Paste or open the values that were measured at the samples.")
                                                   : acquisitionStatus(m_session, m_controls));
}

}  // namespace gonio::app

#include "moc_reconstruction_page.cpp"
