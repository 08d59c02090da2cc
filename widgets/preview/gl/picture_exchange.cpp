// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/picture_exchange.h"

#include "core/support/error.h"

namespace gonio::widgets {

void PictureExchange::begin(Gl& gl, const QSize& size) {
  {
    const std::lock_guard lock(mutex_);
    drawn_ = 0;
    while (drawn_ == newest_ || drawn_ == shown_) ++drawn_;
  }
  Slot& slot = slots_[std::size_t(drawn_)];
  if (slot.read) {
    gl.glWaitSync(slot.read, 0, GL_TIMEOUT_IGNORED);
    gl.glDeleteSync(slot.read);
    slot.read = nullptr;
  }
  if (slot.texture == 0) gl.glGenTextures(1, &slot.texture);
  if (slot.size != size) {
    gl.glActiveTexture(GL_TEXTURE0);
    gl.glBindTexture(GL_TEXTURE_2D, slot.texture);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width(), size.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    slot.size = size;
  }
  if (framebuffer_ == 0) gl.glGenFramebuffers(1, &framebuffer_);
  gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, slot.texture, 0);
  if (gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error("the graphics driver does not draw into textures");
}

void PictureExchange::publish(Gl& gl) {
  gl.glFinish();
  const std::lock_guard lock(mutex_);
  newest_ = drawn_;
}

bool PictureExchange::show(Gl& gl, GLuint framebuffer, const QSize& viewport) {
  {
    const std::lock_guard lock(mutex_);
    if (newest_ < 0) return false;
    shown_ = newest_;
  }
  Slot& slot = slots_[std::size_t(shown_)];
  // Framebuffers are not shared: one of this context, for the moment.
  GLuint source = 0;
  gl.glGenFramebuffers(1, &source);
  gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
  gl.glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, slot.texture, 0);
  gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  gl.glBlitFramebuffer(0, 0, slot.size.width(), slot.size.height(), 0, 0, viewport.width(), viewport.height(),
                       GL_COLOR_BUFFER_BIT, slot.size == viewport ? GL_NEAREST : GL_LINEAR);
  gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.glDeleteFramebuffers(1, &source);
  if (slot.read) gl.glDeleteSync(slot.read);
  slot.read = gl.glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.glFlush();  // the other context can wait for a fence only after it was sent
  return true;
}

void PictureExchange::release(Gl& gl) {
  for (Slot& slot : slots_) {
    if (slot.read) gl.glDeleteSync(slot.read);
    if (slot.texture) gl.glDeleteTextures(1, &slot.texture);
    slot = {};
  }
  if (framebuffer_) gl.glDeleteFramebuffers(1, &framebuffer_);
  framebuffer_ = 0;
  const std::lock_guard lock(mutex_);
  newest_ = shown_ = -1;
}

}  // namespace gonio::widgets
