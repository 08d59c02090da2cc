// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QCoreApplication>
#include <QFuture>
#include <QFutureWatcher>
#include <QObject>
#include <QSize>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <new>
#include <optional>
#include <stop_token>

#include "core/rendering/path_tracer.h"
#include "core/rendering/render_material.h"
#include "core/support/error.h"
#include "widgets/preview/gl/preview_subject.h"
#include "widgets/preview/picture_drawer.h"

namespace gonio::widgets {

/// Converts exceptions of work in another thread to messages. Otherwise QFuture would rethrow them in every function
/// that waits for it, including destructors.
class TaskFailure {
  Q_DECLARE_TR_FUNCTIONS(TaskFailure)

 public:
  /// Runs the work. @return a message for the user if it threw; empty if it was finished or cancelled.
  template <typename Work>
  static QString of(const Work& work) {
    try {
      work();
    } catch (const Cancelled&) {
      return {};
    } catch (const std::bad_alloc&) {
      return tr("Not enough memory. Close other windows or programs and try again.");
    } catch (const std::exception& exception) {
      return QString::fromUtf8(exception.what());
    }
    return {};
  }
};

/// The properties of a subject that rendering needs.
struct MaterialEstimate {
  std::shared_ptr<const TabulatedDensity> density;
  std::shared_ptr<const rendering::RenderMaterial> material;
};

/// Estimates a subject's sampling density and albedo in another thread: about 10 ms, or about 100 ms for a blend of
/// codes with different dictionaries. The first of several requests is processed at once, the newest of the others when
/// none has come for timeToRest: while a slider moves, the cores draw.
class MaterialEstimator : public QObject {
  Q_OBJECT

 public:
  explicit MaterialEstimator(QObject* parent = nullptr);
  ~MaterialEstimator() override;

  void request(const PreviewSubject& subject);
  /// Drops all requests; their results are not reported.
  void cancel();
  bool isBusy() const { return m_running || m_next; }

 Q_SIGNALS:
  void estimated(const gonio::widgets::MaterialEstimate& estimate);
  /// The newest request failed.
  void failed(const QString& message);

 private:
  void start();
  void finish();

  struct Outcome {
    MaterialEstimate estimate;
    QString failure;  ///< empty on success
  };
  QThreadPool m_pool;  ///< separate from the global pool, which Qt uses for painting, so that painting does not wait
  QFutureWatcher<Outcome> m_watcher;
  std::optional<PreviewSubject> m_next;
  QTimer m_rest;  ///< active for timeToRest after a request
  bool m_running = false, m_wanted = false;
};

/// Path-traces a scene in another thread: coarse pictures first, then at full size with an increasing number of
/// samples. Only the newest request is processed.
class SceneTracer : public QObject {
  Q_OBJECT

 public:
  explicit SceneTracer(QObject* parent = nullptr);
  ~SceneTracer() override;

  /// @param slotMaterials materials of the scene's slots. The previous picture stays until the first new one is
  /// finished.
  void trace(const rendering::Scene& scene, const rendering::RenderMaterials& slotMaterials,
             const rendering::EffectPlan& plan, const QSize& size, int samples);
  void stop();

  /// Whether film() belongs to the last request and the request was not stopped.
  bool isCurrent() const { return m_isCurrent; }
  /// Whether film() belongs to the last request and has all its samples.
  bool isDone() const { return m_isDone; }
  /// The newest picture; null before the first one. Smaller than requested while it is coarse.
  const std::shared_ptr<const rendering::Film>& film() const { return m_film; }
  /// Time of the last pass divided by its samples per pixel, at the size of film(), ms.
  double millisecondsPerSample() const { return m_milliseconds; }

 Q_SIGNALS:
  void advanced();
  /// The newest request failed.
  void failed(const QString& message);

 private:
  void adopt(int request, std::shared_ptr<const rendering::Film> film, double milliseconds);

  std::shared_ptr<const rendering::Film> m_film;
  std::stop_source m_stop;
  QThreadPool m_pool;  ///< separate from the global pool, which Qt uses for painting, so that painting does not wait
  QFuture<void> m_future;
  double m_milliseconds = 0;
  int m_request = 0, m_samples = 0;
  bool m_isCurrent = false, m_isDone = false;
};

/// One subject of the preview with the results of background work: its sampling density and albedo, the plan of its
/// effects, and its path-traced picture if there is one.
class PreviewSide : public QObject {
  Q_OBJECT

 public:
  explicit PreviewSide(QObject* parent = nullptr);

  /// @return whether the subject changed.
  bool setSubject(const PreviewSubject& subject);
  const PreviewSubject& subject() const { return m_subject; }
  void setName(const QString& name) { m_name = name; }
  const QString& name() const { return m_name; }

  void setPlan(const rendering::EffectPlan& plan) { m_plan = plan; }
  const rendering::EffectPlan& plan() const { return m_plan; }
  /// The subject in the form for core/rendering; null until it is known.
  const std::shared_ptr<const rendering::RenderMaterial>& material() const { return m_material; }
  SceneTracer& tracer() { return m_tracer; }
  const SceneTracer& tracer() const { return m_tracer; }
  bool isEstimating() const { return m_estimator.isBusy(); }

  PictureRequest::Side request() const { return {m_subject, m_number, m_plan, nullptr}; }

 Q_SIGNALS:
  /// The material is known; the sampling density may have changed, too.
  void estimated();
  void failed(const QString& message);

 private:
  void adopt(const MaterialEstimate& estimate);

  PreviewSubject m_subject;  ///< with the sampling density that is used for rendering
  PreviewSubject m_given;
  int m_number = 0;  ///< of the subject and its density
  QString m_name;
  MaterialEstimator m_estimator;
  std::shared_ptr<const rendering::RenderMaterial> m_material;
  rendering::EffectPlan m_plan;
  SceneTracer m_tracer;
};

}  // namespace gonio::widgets
