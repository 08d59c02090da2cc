// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/gl/edit_chain.h"
#include "widgets/preview/gl/preview_resources.h"
#include "widgets/preview/gl/preview_subject.h"
#include "widgets/preview/gl/textures.h"

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
  /// @param gl functions of the context of bind(), which must be current; null if there is no context.
  void release(QOpenGLFunctions_4_1_Core* gl);

 private:
  void bindDetail(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, const PreviewBlend& blend);

  std::shared_ptr<const MixtureTextures> textures_;
  FactorTexture curves_;
  std::shared_ptr<ShaderBase> own_;
  std::shared_ptr<const Brdf> uploadedOwn_;
  std::shared_ptr<const interpolation::TransformedMixture> uploaded_;
};

/// One subject on the graphics card, for shaders/preview/material.glsl and sampling_density.glsl. Uploaded data stay
/// until they are replaced.
class SubjectTextures {
 public:
  /// Adds the definitions and preamble files of the shader variant.
  static void addVariant(const PreviewSubject& subject, QStringList& definitions, QStringList& preamble);
  /// Uploads new data, binds the textures to their units and sets the uniforms of a shader of that variant.
  /// @param samplesDirections whether the shader samples reflection directions with the subject's density.
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
            const PreviewSubject& subject, bool samplesDirections);
  /// @param gl functions of the context of bind(), which must be current; null if there is no context.
  void release(QOpenGLFunctions_4_1_Core* gl);

 private:
  void bindBase(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
                const EditedMaterial& material);
  void bindTable(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
                 const EditedMaterial& material);
  void bindDensity(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program,
                   const std::shared_ptr<const TabulatedDensity>& density);

  std::shared_ptr<const TableTexture> tableTexture_;
  std::shared_ptr<ShaderBase> shaderBase_;
  std::unique_ptr<TextureSet> densityTextures_;
  EditChain editChain_;
  BlendTextures blendTextures_;
  std::shared_ptr<const Brdf> uploadedBase_;
  std::shared_ptr<const TabulatedDensity> uploadedDensity_;
};

}  // namespace gonio::widgets
