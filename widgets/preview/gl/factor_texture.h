// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <span>
#include <vector>

#include "core/editing/factor_edit.h"

namespace gonio::widgets {

/// The curves of factor edits on the graphics card, for shaders/preview/factors.glsl: resampled at 1,024 points (fewer
/// if the driver's buffers are too small), uniform in theta_R, in the square root of |Dp| (denser near 0, as are the
/// nodes of sharp highlights) and in |phi|. The curves of all edits are in one texture buffer, which is read by index.
/// While curves are dragged only the texels of their edit are uploaded: 64 kB per term in the form with two factors.
class FactorTexture {
 public:
  /// The sizes that the shader is compiled for.
  static int termsOf(const editing::FactorEdit& edit);
  static int axesOf(const editing::FactorEdit& edit);
  /// Uploads the curves that changed to the texture at the active unit.
  void update(QOpenGLFunctions_4_1_Core& gl, const std::vector<editing::FactorEdit>& edits);
  /// Sets the shader's uniforms. @param unit the texture unit of the buffer.
  void setUniforms(QOpenGLShaderProgram& program, int unit) const;
  /// Frees the texture.
  void release(QOpenGLFunctions_4_1_Core& gl);

 private:
  bool sameLayout(const std::vector<editing::FactorEdit>& edits) const;
  void allocate(QOpenGLFunctions_4_1_Core& gl, const std::vector<editing::FactorEdit>& edits);

  std::vector<editing::FactorEdit> edits_;  ///< as uploaded
  std::vector<int> firstTexels_;            ///< first texel of each edit
  GLuint texture_ = 0, buffer_ = 0;
  int places_ = 0;
};

}  // namespace gonio::widgets
