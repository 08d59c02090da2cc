// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/gl/preview_resources.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

/// The materials of a blend on the graphics card, for shaders/preview/blend.glsl. While a point is dragged between them
/// only uniforms change.
class BlendTextures {
 public:
  /// What the shader is compiled for.
  static void addVariant(const PreviewBlend& blend, QStringList& definitions, QStringList& preamble);
  /// Uploads a mixture that is new (about 20 ms per material), binds it to its units, sets the shader's uniforms.
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
            const PreviewBlend& blend);
  /// In the context of bind().
  void release();

 private:
  std::shared_ptr<const MixtureTextures> textures_;
  std::shared_ptr<ShaderBase> own_;
  std::shared_ptr<const Brdf> uploadedOwn_;
  std::shared_ptr<const editing::TransformedMixture> uploaded_;
};

/// Definitions and files of a shader that evaluates a model in the place of a measurement.
void addModelAlone(const models::Model& model, const models::ParameterValues& values, QStringList& definitions,
                   QStringList& preamble);
/// Definitions and files that a shader with a model's formula needs.
void addModel(const models::Model& model, const models::ParameterValues& values, QStringList& definitions,
              QStringList& preamble);

}  // namespace gonio::widgets
