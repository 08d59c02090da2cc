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

/// Adds the definitions and files of a shader that evaluates a model in place of a measurement.
void addModelAlone(const models::Model& model, const models::ParameterValues& values, QStringList& definitions,
                   QStringList& preamble);
/// Adds the definitions and files of a shader that contains a model's formula.
void addModel(const models::Model& model, const models::ParameterValues& values, QStringList& definitions,
              QStringList& preamble);

}  // namespace gonio::widgets
