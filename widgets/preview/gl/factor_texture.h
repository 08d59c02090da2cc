// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>

#include "core/editing/factor_edit.h"

namespace gonio::widgets {

/// The curves of a factor edit on the graphics card, for shaders/preview/factors.glsl: resampled to 1,024 places, even
/// in theta_R, in the root of |Dp| (where sharp highlights have their nodes) and in |phi|; fewer where the driver's
/// buffers do not hold as many. A texture buffer, since it is read without the arithmetic of pictures. While curves are
/// dragged only these texels change: 64 kB a term in the form with two factors.
class FactorTexture {
 public:
  /// What the shader is compiled for.
  static QStringList definitions(const editing::FactorEdit& edit);
  /// Brings the curves to the texture at the active unit where they are others than before.
  void update(QOpenGLFunctions_4_1_Core& gl, const editing::FactorEdit& edit);
  /// The shader's uniforms. @param unit at which the texture is bound.
  void setUniforms(QOpenGLShaderProgram& program, int unit) const;
  /// Frees the texture.
  void release(QOpenGLFunctions_4_1_Core& gl);

 private:
  editing::FactorEdit::Curves original_, edited_;
  GLuint texture_ = 0, buffer_ = 0;
  int places_ = 0;
};

}  // namespace gonio::widgets
