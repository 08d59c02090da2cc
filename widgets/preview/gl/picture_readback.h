// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QOpenGLFunctions_4_1_Core>

namespace gonio::widgets {

/// Reads the picture of a framebuffer into memory, so that the window that shows it needs no OpenGL and never waits for
/// rendering.
class PictureReadback {
 public:
  using Gl = QOpenGLFunctions_4_1_Core;

  /// Binds a framebuffer of the given size, with undefined content.
  /// @throws Error if the card cannot create it.
  void begin(Gl& gl, const QSize& size);
  /// Waits until everything drawn since begin() is finished. @return the picture as opaque sRGB, upright.
  QImage read(Gl& gl);
  void release(Gl& gl);

 private:
  QSize size_;
  GLuint framebuffer_ = 0, colours_ = 0;
};

}  // namespace gonio::widgets
