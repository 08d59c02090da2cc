// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/picture_readback.h"

#include <utility>

#include "core/support/error.h"

namespace gonio::widgets {

void PictureReadback::begin(Gl& gl, const QSize& size) {
  if (framebuffer_ == 0) {
    gl.glGenFramebuffers(1, &framebuffer_);
    gl.glGenRenderbuffers(1, &colours_);
  }
  gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  if (size_ == size) return;
  gl.glBindRenderbuffer(GL_RENDERBUFFER, colours_);
  gl.glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width(), size.height());
  gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_);
  if (gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error("the graphics driver cannot create a framebuffer of the preview's size");
  size_ = size;
}

QImage PictureReadback::read(Gl& gl) {
  QImage picture(size_, QImage::Format_RGB32);
  gl.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.glReadPixels(0, 0, size_.width(), size_.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, picture.bits());
  return std::move(picture).mirrored();  // OpenGL's first row is the lowest
}

void PictureReadback::release(Gl& gl) {
  if (framebuffer_) gl.glDeleteFramebuffers(1, &framebuffer_);
  if (colours_) gl.glDeleteRenderbuffers(1, &colours_);
  framebuffer_ = colours_ = 0;
  size_ = {};
}

}  // namespace gonio::widgets
