// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/material_estimator.h"

#include <QtConcurrentRun>

#include "widgets/preview/task_failure.h"

namespace gonio::widgets {

MaterialEstimator::MaterialEstimator(QObject* parent) : QObject(parent) {
  connect(&m_watcher, &QFutureWatcher<Outcome>::finished, this, &MaterialEstimator::finish);
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
  m_watcher.setFuture(QtConcurrent::run(&m_pool, [subject] {
    Outcome outcome;
    outcome.failure = TaskFailure::of([&] {
      const std::shared_ptr<const Brdf> brdf = subjectBrdf(subject);
      // The lobe of a measurement as it is may have come with it.
      auto lobe = subject.isMeasured() && subject.lobe ? subject.lobe : std::make_shared<const TabulatedDensity>(*brdf);
      outcome.estimate = {lobe, std::make_shared<const RenderMaterial>(brdf, lobe)};
    });
    return outcome;
  }));
}

void MaterialEstimator::finish() {
  m_busy = false;
  if (m_next) {
    const PreviewSubject next = *m_next;
    m_next.reset();
    return start(next);
  }
  if (!m_wanted) return;
  const Outcome outcome = m_watcher.result();
  if (outcome.failure.isEmpty())
    Q_EMIT estimated(outcome.estimate);
  else
    Q_EMIT failed(outcome.failure);
}

}  // namespace gonio::widgets

#include "moc_material_estimator.cpp"
