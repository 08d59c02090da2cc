// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <span>
#include <vector>

#include "core/editing/factor_edit.h"

namespace gonio::widgets {

/// The curves of factor edits on the graphics card, for shaders/preview/factors.glsl: resampled to 1,024 places, even
/// in theta_R, in the root of |Dp| (where sharp highlights have their nodes) and in |phi|; fewer where the driver's
/// buffers do not hold as many. A texture buffer, since it is read without the arithmetic of pictures; one edit behind
/// the other. While curves are dragged only the texels of their edit change: 64 kB a term in the form with two factors.
class FactorTexture {
 public:
  /// The sizes that the shader is compiled for.
  static int termsOf(const editing::FactorEdit& edit);
  static int axesOf(const editing::FactorEdit& edit);
  /// Brings the curves to the texture at the active unit where they are others than before.
  void update(QOpenGLFunctions_4_1_Core& gl, const std::vector<editing::FactorEdit>& edits);
  /// The shader's uniforms. @param unit at which the texture is bound.
  void setUniforms(QOpenGLShaderProgram& program, int unit) const;
  /// Frees the texture.
  void release(QOpenGLFunctions_4_1_Core& gl);

 private:
  bool sameLayout(const std::vector<editing::FactorEdit>& edits) const;
  void allocate(QOpenGLFunctions_4_1_Core& gl, const std::vector<editing::FactorEdit>& edits);

  std::vector<editing::FactorEdit> edits_;  ///< as uploaded
  std::vector<int> firstTexels_;            ///< of each edit
  GLuint texture_ = 0, buffer_ = 0;
  int places_ = 0;
};

}  // namespace gonio::widgets
