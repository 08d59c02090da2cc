// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/material_estimator.h"

#include <QtConcurrentRun>
#include <cmath>

namespace gonio::widgets {

MaterialEstimator::MaterialEstimator(QObject* parent) : QObject(parent) {
  connect(&m_watcher, &QFutureWatcher<MaterialEstimate>::finished, this, &MaterialEstimator::finish);
}

MaterialEstimator::~MaterialEstimator() { m_watcher.waitForFinished(); }

void MaterialEstimator::request(const PreviewSubject& subject) {
  if (subject.isEmpty()) return cancel();
  m_wanted = true;
  if (m_busy)
    m_next = subject;
  else
    start(subject);
}

void MaterialEstimator::cancel() {
  m_next.reset();
  m_wanted = false;
}

void MaterialEstimator::start(const PreviewSubject& subject) {
  m_busy = true;
  m_watcher.setFuture(QtConcurrent::run([subject] {
    const std::shared_ptr<const Brdf> brdf = subjectBrdf(subject);
    // The lobe of a table as it is has come with it.
    const SamplingLobe lobe = subject.isMeasured() ? subject.lobe : estimateSamplingLobe(*brdf);
    return MaterialEstimate{lobe, std::make_shared<const RenderMaterial>(brdf, lobe)};
  }));
}

void MaterialEstimator::finish() {
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

#include "moc_material_estimator.cpp"
