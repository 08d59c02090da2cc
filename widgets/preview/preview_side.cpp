// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_side.h"

#include <QtConcurrentRun>
#include <algorithm>
#include <chrono>

namespace gonio::widgets {

MaterialEstimator::MaterialEstimator(QObject* parent) : QObject(parent) {
  m_rest.setSingleShot(true);
  m_rest.setInterval(timeToRest);
  connect(&m_rest, &QTimer::timeout, this, [this] {
    if (m_next && !m_running) start();
  });
  connect(&m_watcher, &QFutureWatcher<Outcome>::finished, this, &MaterialEstimator::finish);
}

MaterialEstimator::~MaterialEstimator() { m_watcher.waitForFinished(); }

void MaterialEstimator::request(const PreviewSubject& subject) {
  if (subject.isEmpty()) return cancel();
  m_wanted = true;
  m_next = subject;
  if (!m_running && !m_rest.isActive()) start();
  m_rest.start();
}

void MaterialEstimator::cancel() {
  m_next.reset();
  m_wanted = false;
}

void MaterialEstimator::start() {
  m_running = true;
  const PreviewSubject subject = *std::exchange(m_next, std::nullopt);
  m_watcher.setFuture(QtConcurrent::run(&m_pool, [subject] {
    Outcome outcome;
    outcome.failure = TaskFailure::of([&] {
      const std::shared_ptr<const Brdf> brdf = subjectBrdf(subject);
      // The density of a measurement as it is may have come with it.
      auto density =
          subject.isMeasured() && subject.density ? subject.density : std::make_shared<const TabulatedDensity>(*brdf);
      outcome.estimate = {density, std::make_shared<const rendering::RenderMaterial>(brdf, density)};
      // The effect plan asks for it in the GUI thread.
      outcome.estimate.material->bound();
    });
    return outcome;
  }));
}

void MaterialEstimator::finish() {
  m_running = false;
  if (m_next) {
    if (!m_rest.isActive()) start();
    return;
  }
  if (!m_wanted) return;
  const Outcome outcome = m_watcher.result();
  if (outcome.failure.isEmpty())
    Q_EMIT estimated(outcome.estimate);
  else
    Q_EMIT failed(outcome.failure);
}

namespace {

/// Sizes of the pictures before the full one, as fractions of its sides.
constexpr int coarseDivisors[] = {4, 2};

using ProgressCallback = std::function<void(std::shared_ptr<const rendering::Film>, double milliseconds)>;

void traceProgressively(const rendering::PathTracer& tracer, const QSize& size, int samples, const TaskControl& control,
                        const ProgressCallback& onProgress) {
  const auto pass = [&](rendering::Film& film, int count) {
    const auto start = std::chrono::steady_clock::now();
    tracer.accumulate(film, count, control);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    onProgress(std::make_shared<const rendering::Film>(film), elapsed.count() / count);
  };
  for (const int divisor : coarseDivisors) {
    rendering::Film coarse(std::max(1, size.width() / divisor), std::max(1, size.height() / divisor));
    coarse.enableFeatures();
    pass(coarse, 1);
  }
  rendering::Film film(size.width(), size.height());
  film.enableFeatures();
  while (film.samples < samples) pass(film, std::min(std::max(1, film.samples), samples - film.samples));
}

}  // namespace

SceneTracer::SceneTracer(QObject* parent) : QObject(parent) {
  // One after the other: two at once would take each other's cores.
  m_pool.setMaxThreadCount(1);
}

SceneTracer::~SceneTracer() {
  stop();
  m_future.waitForFinished();
}

void SceneTracer::stop() {
  m_stop.request_stop();
  ++m_request;
  m_isCurrent = m_isDone = false;
}

void SceneTracer::trace(const rendering::Scene& scene, const rendering::RenderMaterials& slotMaterials,
                        const rendering::EffectPlan& plan, const QSize& size, int samples) {
  stop();
  m_stop = std::stop_source();
  m_samples = samples;
  const ProgressCallback onProgress = [this, request = m_request](const std::shared_ptr<const rendering::Film>& film,
                                                                  double milliseconds) {
    QMetaObject::invokeMethod(
        this, [this, request, film, milliseconds] { adopt(request, film, milliseconds); }, Qt::QueuedConnection);
  };
  const auto tellFailure = [this, request = m_request](const QString& failure) {
    const auto tellOne = [this, request, failure] {
      if (request == m_request) Q_EMIT failed(failure);
    };
    QMetaObject::invokeMethod(this, tellOne, Qt::QueuedConnection);
  };
  m_future = QtConcurrent::run(&m_pool, [=, control = TaskControl{m_stop.get_token(), {}}] {
    const QString failure = TaskFailure::of([&] {
      traceProgressively(rendering::PathTracer(scene, rendering::bindMaterials(scene, slotMaterials), plan), size,
                         samples, control, onProgress);
    });
    if (!failure.isEmpty()) tellFailure(failure);
  });
}

void SceneTracer::adopt(int request, std::shared_ptr<const rendering::Film> film, double milliseconds) {
  if (request != m_request) return;
  m_film = std::move(film);
  m_isCurrent = true;
  m_milliseconds = milliseconds;
  m_isDone = m_film->samples >= m_samples;
  Q_EMIT advanced();
}

PreviewSide::PreviewSide(QObject* parent) : QObject(parent) {
  connect(&m_estimator, &MaterialEstimator::estimated, this, &PreviewSide::adopt);
  connect(&m_estimator, &MaterialEstimator::failed, this, &PreviewSide::failed);
  connect(&m_tracer, &SceneTracer::failed, this, &PreviewSide::failed);
}

bool PreviewSide::setSubject(const PreviewSubject& subject) {
  if (sameSubject(subject, m_given)) return false;
  // The density of the step before serves until the new one is known.
  const bool keepsDensity = !subject.isMeasured() && !m_given.isMeasured();
  const auto density = keepsDensity ? m_subject.density : subject.density;
  m_given = m_subject = subject;
  m_subject.density = density;
  ++m_number;
  m_tracer.stop();
  if (subject.isEmpty()) m_material.reset();
  m_estimator.request(subject);
  return true;
}

void PreviewSide::adopt(const MaterialEstimate& estimate) {
  m_material = estimate.material;
  if (!m_subject.density || !areSimilar(*estimate.density, *m_subject.density)) {
    m_subject.density = estimate.density;
    ++m_number;
  }
  Q_EMIT estimated();
}

}  // namespace gonio::widgets

#include "moc_preview_side.cpp"
