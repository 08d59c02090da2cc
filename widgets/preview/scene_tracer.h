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

/// Traces a scene in another thread: a coarse picture first, then full size with ever more samples. The
/// newest request alone is worked on.
class SceneTracer : public QObject {
  Q_OBJECT

 public:
  explicit SceneTracer(QObject* parent = nullptr);
  ~SceneTracer() override;

  /// @param slotMaterials of the scene's slots. The picture before stays until the first new one is there.
  void trace(const Scene& scene, const RenderMaterials& slotMaterials, const EffectPlan& plan, const QSize& size,
             int samples);
  void stop();

  /// Whether film() is of the picture that was last asked for, and not stopped since.
  bool isCurrent() const { return m_isCurrent; }
  /// Whether it is there with all its samples.
  bool isDone() const { return m_isDone; }
  /// The picture reached so far; null before the first. Smaller than asked for while it is coarse.
  const std::shared_ptr<const Film>& film() const { return m_film; }
  /// Of the last pass, one sample per pixel at full size.
  double millisecondsOfSample() const { return m_milliseconds; }

 Q_SIGNALS:
  void advanced();
  /// The newest request came to nothing.
  void failed(const QString& message);

 private:
  void adopt(int request, std::shared_ptr<const Film> film, double milliseconds);

  std::shared_ptr<const Film> m_film;
  std::stop_source m_stop;
  QThreadPool m_pool;  ///< not the global one, which Qt paints with: painting would wait for this work
  QFuture<void> m_future;
  double m_milliseconds = 0;
  int m_request = 0, m_samples = 0;
  bool m_isCurrent = false, m_isDone = false;
};

}  // namespace gonio::widgets
