// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/gl/factor_texture.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

/// The edits of a base in shaders/preview/material.glsl: a step of generated text for each that changes something, in
/// the order of the list. A variant depends on the kinds of edits, their models and, of edits by lobes, the parts that
/// change; values are uniforms and the texels of curves.
class EditChain {
 public:
  /// What the shader is compiled for; nothing where no edit changes something and the base is no factors.
  /// @param base the factors that the base is, null for others: the first of the curves in the shader.
  static void addVariant(const editing::EditList& edits, QStringList& definitions, QStringList& preamble,
                         const factorization::PdvFactors* base = nullptr);
  /// Sets the uniforms of a shader of that variant, and brings the curves of factor edits to `unit`.
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, const editing::EditList& edits, int unit,
            std::shared_ptr<const factorization::PdvFactors> base = nullptr);
  /// In the context of bind().
  void release(QOpenGLFunctions_4_1_Core& gl) { factors_.release(gl); }

 private:
  FactorTexture factors_;
};

}  // namespace gonio::widgets
