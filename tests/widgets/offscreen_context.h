// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace gonio::test {

/// An OpenGL 4.1 core context without a window, current while alive. Tests skip when isValid() is false.
class OffscreenContext {
 public:
  OffscreenContext() {
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    context_.setFormat(format);
    surface_.setFormat(format);
    surface_.create();
    valid_ = context_.create() && surface_.isValid() && context_.makeCurrent(&surface_) &&
             context_.format().version() >= qMakePair(4, 1);
  }
  ~OffscreenContext() { context_.doneCurrent(); }
  bool isValid() const { return valid_; }

 private:
  QOffscreenSurface surface_;
  QOpenGLContext context_;
  bool valid_ = false;
};

}  // namespace gonio::test
