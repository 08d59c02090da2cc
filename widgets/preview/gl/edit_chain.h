// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <span>
#include <vector>

#include "core/editing/edit.h"
#include "widgets/preview/gl/preview_subject.h"

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

/// The edits of a base in shaders/preview/material.glsl: one step of generated code per edit with an effect, in the
/// order of the list. A shader variant depends on the kinds of edits, their models and, for edits by lobes, the parts
/// that change; values are in uniforms and, for curves, in texels.
class EditChain {
 public:
  /// Adds the definitions and preamble files of the shader variant; none if no edit has an effect and the base has no
  /// factors.
  /// @param base the factors if the base is a factorization, else null. They are the first curves in the shader.
  static void addVariant(const editing::EditList& edits, QStringList& definitions, QStringList& preamble,
                         const factorization::PdvFactors* base = nullptr);
  /// Sets the uniforms of a shader of that variant and uploads the curves of factor edits to `unit`. Where highlights
  /// keep their albedo, their factors are computed when the edits change (editing::albedoScales()).
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, const editing::EditList& edits, int unit,
            const std::shared_ptr<const Brdf>& base);
  /// Call with the context of bind() current.
  void release(QOpenGLFunctions_4_1_Core& gl) { factors_.release(gl); }

 private:
  FactorTexture factors_;
  std::vector<editing::AlbedoScale> scales_;  ///< of scaledEdits_ on scaledBase_
  std::shared_ptr<const Brdf> scaledBase_;
  editing::EditList scaledEdits_;
};

}  // namespace gonio::widgets
