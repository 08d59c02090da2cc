// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QThread>
#include <memory>

#include "widgets/preview/picture_request.h"

class QOffscreenSurface;
class QSurfaceFormat;

namespace gonio::widgets {

/// Draws the preview's pictures in a thread and an OpenGL context of its own, and hands them over in memory: compiling
/// shaders, uploading tables, and waiting for the card do not hold up the GUI thread, nor what the window itself shows.
/// Where the platform has no OpenGL in several threads, it draws in this one, between its events.
class PictureThread : public QObject {
  Q_OBJECT

 public:
  explicit PictureThread(QObject* parent = nullptr);
  ~PictureThread() override;

  /// Starts, unless it has. What was requested before is drawn then.
  void start(const QSurfaceFormat& format);
  /// Ends the frame that is being drawn, frees what belongs to the context.
  void stop();

  /// Draws this from now on, until it has all its samples.
  void request(const PictureRequest& request);
  /// Waits for one more frame of what is requested; no drawn() comes for it.
  PictureState drawNow();
  /// Waits for the linear radiance of the first side so far.
  Image readFirst();

 Q_SIGNALS:
  /// @param graphics what OpenGL says of itself: renderer, maker, version; @param software it runs on the CPU.
  void started(const QString& graphics, bool software);
  void drawn(const gonio::widgets::PictureState& state);
  /// The picture that is wanted is late: a shader comes first.
  void compiling();
  void failed(const QString& message);

 private:
  class Worker;
  void inThread(const std::function<void()>& work);

  std::shared_ptr<const PictureRequest> m_request;
  QThread m_thread;
  std::unique_ptr<QOffscreenSurface> m_surface;  ///< is made and goes in the GUI thread
  std::unique_ptr<Worker> m_worker;              ///< null: not started
};

}  // namespace gonio::widgets
