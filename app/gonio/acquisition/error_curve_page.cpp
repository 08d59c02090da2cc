// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/error_curve_page.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include "widgets/acquisition/error_curve.h"

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

}  // namespace gonio::app

#include "moc_error_curve_page.cpp"
