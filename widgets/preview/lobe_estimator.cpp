// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/lobe_estimator.h"

#include <QtConcurrentRun>
#include <cmath>

namespace gonio::widgets {

LobeEstimator::LobeEstimator(QObject* parent) : QObject(parent) {
  connect(&m_watcher, &QFutureWatcher<SamplingLobe>::finished, this, &LobeEstimator::finish);
}

LobeEstimator::~LobeEstimator() { m_watcher.waitForFinished(); }

void LobeEstimator::request(const PreviewSubject& subject) {
  if (subject.isEmpty()) return cancel();
  m_wanted = true;
  if (m_busy)
    m_next = subject;
  else
    start(subject);
}

void LobeEstimator::cancel() {
  m_next.reset();
  m_wanted = false;
}

void LobeEstimator::start(const PreviewSubject& subject) {
  m_busy = true;
  m_watcher.setFuture(QtConcurrent::run([subject] { return estimateSamplingLobe(*subjectBrdf(subject)); }));
}

void LobeEstimator::finish() {
  m_busy = false;
  if (m_next) {
    const PreviewSubject next = *m_next;
    m_next.reset();
    return start(next);
  }
  if (m_wanted) Q_EMIT estimated(m_watcher.result());
}

bool similarLobes(const SamplingLobe& a, const SamplingLobe& b) {
  constexpr double largestRatio = 1.2, largestDifference = 0.1;
  return std::abs(std::log(a.roughness / b.roughness)) < std::log(largestRatio) &&
         std::abs(a.specularShare - b.specularShare) < largestDifference;
}

}  // namespace gonio::widgets

#include "moc_lobe_estimator.cpp"
