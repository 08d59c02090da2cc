// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QSize>
#include <array>
#include <mutex>

namespace gonio::widgets {

/// Pictures that one OpenGL context draws and another shows, each in its own thread and at its own pace. Of three
/// textures one is drawn into, one is the newest finished, one is shown; none waits for another. The contexts share
/// their objects.
class PictureExchange {
 public:
  using Gl = QOpenGLFunctions_4_1_Core;

  /// The side that draws: binds a framebuffer of that size, with undefined content.
  /// @throws Error when the card has none.
  void begin(Gl& gl, const QSize& size);
  /// Waits until what was drawn since begin() is done, then makes it the newest.
  void publish(Gl& gl);
  /// Frees all; the other side must not be showing.
  void release(Gl& gl);

  /// The side that shows: copies the newest picture over the viewport of a framebuffer, stretched where it has another
  /// size, and leaves that framebuffer bound. @returns whether there is one.
  bool show(Gl& gl, GLuint framebuffer, const QSize& viewport);

 private:
  struct Slot {
    GLuint texture = 0;
    QSize size;
    GLsync read = nullptr;  ///< passed when the card has shown it for the last time
  };

  std::array<Slot, 3> slots_;
  std::mutex mutex_;              ///< of the numbers below
  int newest_ = -1, shown_ = -1;  ///< of slots_; -1: none
  int drawn_ = 0;                 ///< this and the framebuffer concern the side that draws alone
  GLuint framebuffer_ = 0;
};

}  // namespace gonio::widgets
