// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QThread>
#include <memory>

#include "widgets/preview/gl/picture_exchange.h"
#include "widgets/preview/picture_request.h"

class QOffscreenSurface;
class QOpenGLContext;

namespace gonio::widgets {

/// Draws the preview's pictures in a thread of its own, with an OpenGL context that shares the widget's objects:
/// compiling shaders, uploading tables, and waiting for the card do not hold up the GUI thread. Where the platform
/// has no OpenGL in several threads, it draws in this one, between its events.
class PictureThread : public QObject {
  Q_OBJECT

 public:
  explicit PictureThread(QObject* parent = nullptr);
  ~PictureThread() override;

  /// Starts with nothing drawn. What was requested before is drawn then.
  void start(QOpenGLContext& shared);
  /// Ends the frame that is being drawn, frees what belongs to the context. To be called before that goes.
  void stop();

  /// Draws this from now on, until it has all its samples.
  void request(const PictureRequest& request);
  /// Waits for one more frame of what is requested; no drawn() comes for it.
  PictureState drawNow();
  /// Waits for the linear radiance of the first side so far.
  Image readFirst();
  /// PictureExchange::show(), in the context that start() was given.
  bool show(QOpenGLFunctions_4_1_Core& gl, GLuint framebuffer, const QSize& viewport);

 Q_SIGNALS:
  /// A picture is there for show().
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
  std::unique_ptr<PictureExchange> m_exchange;
};

}  // namespace gonio::widgets
