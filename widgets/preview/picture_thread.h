// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QThread>
#include <memory>

#include "widgets/preview/picture_drawer.h"

class QOffscreenSurface;
class QSurfaceFormat;

namespace gonio::widgets {

/// Renders the preview's pictures in a separate thread and OpenGL context and delivers them in memory, so that
/// compiling shaders, uploading tables and waiting for the card do not block the GUI thread. If the platform does not
/// support OpenGL in several threads, it renders in the GUI thread between events.
class PictureThread : public QObject {
  Q_OBJECT

 public:
  explicit PictureThread(QObject* parent = nullptr);
  ~PictureThread() override;

  /// Starts the thread if it is not running, with the last request made before.
  void start(const QSurfaceFormat& format);
  /// Finishes the current frame and frees the OpenGL objects.
  void stop();

  /// Renders this request from now on, until it has all its samples.
  void request(const PictureRequest& request);
  /// Renders one more frame of the current request and waits for it; drawn() is not emitted.
  PictureState drawNow();
  /// The linear radiance of the first side, at the quality reached so far. Waits for the thread.
  Image readFirst();

 Q_SIGNALS:
  /// @param graphics renderer, vendor and version reported by OpenGL; @param software whether it runs on the CPU.
  void started(const QString& graphics, bool software);
  /// OpenGL cannot be started; nothing will be drawn.
  void unavailable(const QString& reason);
  void drawn(const gonio::widgets::PictureState& state);
  /// The requested picture is delayed because a shader is being compiled.
  void compiling();
  /// @param number of the request that failed; INT_MAX if the failure belongs to none.
  void failed(const QString& message, int number);

 private:
  class Worker;
  void inThread(const std::function<void()>& work);

  std::shared_ptr<const PictureRequest> m_request;
  QThread m_thread;
  std::unique_ptr<QOffscreenSurface> m_surface;  ///< created and destroyed in the GUI thread
  std::unique_ptr<Worker> m_worker;              ///< null: not started
};

}  // namespace gonio::widgets
