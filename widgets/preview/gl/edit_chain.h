// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/gl/factor_texture.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

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
  /// Sets the uniforms of a shader of that variant and uploads the curves of factor edits to `unit`.
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, const editing::EditList& edits, int unit,
            const std::shared_ptr<const factorization::PdvFactors>& base = nullptr);
  /// Call with the context of bind() current.
  void release(QOpenGLFunctions_4_1_Core& gl) { factors_.release(gl); }

 private:
  FactorTexture factors_;
};

}  // namespace gonio::widgets
