// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QOpenGLFunctions_4_1_Core>

namespace gonio::widgets {

/// A framebuffer whose picture is read into memory. So the window that shows it needs no OpenGL of its own, and never
/// waits for what is being drawn.
class PictureReadback {
 public:
  using Gl = QOpenGLFunctions_4_1_Core;

  /// Binds a framebuffer of that size, with undefined content.
  /// @throws Error when the card has none.
  void begin(Gl& gl, const QSize& size);
  /// Waits until what was drawn since begin() is done. @returns it as opaque sRGB, upright.
  QImage read(Gl& gl);
  void release(Gl& gl);

 private:
  QSize size_;
  GLuint framebuffer_ = 0, colours_ = 0;
};

}  // namespace gonio::widgets
