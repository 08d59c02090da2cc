// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/gl/preview_resources.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

/// The materials of a blend on the graphics card, for shaders/preview/blend.glsl. If only the weights change, only
/// uniforms are set.
class BlendTextures {
 public:
  /// Adds the definitions and preamble files of the shader variant.
  static void addVariant(const PreviewBlend& blend, QStringList& definitions, QStringList& preamble);
  /// Uploads a new mixture (about 20 ms per material), binds it to its units and sets the shader's uniforms.
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
            const PreviewBlend& blend);
  /// Call with the context of bind() current.
  void release();

 private:
  std::shared_ptr<const MixtureTextures> textures_;
  std::shared_ptr<ShaderBase> own_;
  std::shared_ptr<const Brdf> uploadedOwn_;
  std::shared_ptr<const editing::TransformedMixture> uploaded_;
};

}  // namespace gonio::widgets
