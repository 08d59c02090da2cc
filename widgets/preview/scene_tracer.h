// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFuture>
#include <QObject>
#include <QSize>
#include <QThreadPool>
#include <stop_token>

#include "core/rendering/path_tracer.h"

namespace gonio::widgets {

/// Path-traces a scene in another thread: coarse pictures first, then at full size with an increasing number of
/// samples. Only the newest request is processed.
class SceneTracer : public QObject {
  Q_OBJECT

 public:
  explicit SceneTracer(QObject* parent = nullptr);
  ~SceneTracer() override;

  /// @param slotMaterials materials of the scene's slots. The previous picture stays until the first new one is
  /// finished.
  void trace(const Scene& scene, const RenderMaterials& slotMaterials, const EffectPlan& plan, const QSize& size,
             int samples);
  void stop();

  /// Whether film() belongs to the last request and the request was not stopped.
  bool isCurrent() const { return m_isCurrent; }
  /// Whether film() belongs to the last request and has all its samples.
  bool isDone() const { return m_isDone; }
  /// The newest picture; null before the first one. Smaller than requested while it is coarse.
  const std::shared_ptr<const Film>& film() const { return m_film; }
  /// Time of the last pass divided by its samples per pixel, at the size of film(), ms.
  double millisecondsPerSample() const { return m_milliseconds; }

 Q_SIGNALS:
  void advanced();
  /// The newest request failed.
  void failed(const QString& message);

 private:
  void adopt(int request, std::shared_ptr<const Film> film, double milliseconds);

  std::shared_ptr<const Film> m_film;
  std::stop_source m_stop;
  QThreadPool m_pool;  ///< separate from the global pool, which Qt uses for painting, so that painting does not wait
  QFuture<void> m_future;
  double m_milliseconds = 0;
  int m_request = 0, m_samples = 0;
  bool m_isCurrent = false, m_isDone = false;
};

}  // namespace gonio::widgets
