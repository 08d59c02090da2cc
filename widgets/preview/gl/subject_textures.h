// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/gl/blend_textures.h"
#include "widgets/preview/gl/edit_chain.h"
#include "widgets/preview/gl/preview_resources.h"
#include "widgets/preview/gl/warp_textures.h"

namespace gonio::widgets {

/// One subject on the graphics card, for shaders/preview/material.glsl and sampling_lobe.glsl. Uploaded data stay until
/// they are replaced.
class SubjectTextures {
 public:
  /// Adds the definitions and preamble files of the shader variant.
  static void addVariant(const PreviewSubject& subject, QStringList& definitions, QStringList& preamble);
  /// Uploads new data, binds the textures to their units and sets the uniforms of a shader of that variant.
  /// @param samplesDirections whether the shader samples reflection directions with the subject's lobe.
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
            const PreviewSubject& subject, bool samplesDirections);
  /// @param gl functions of the context of bind(), which must be current; null if there is no context.
  void release(QOpenGLFunctions_4_1_Core* gl);

 private:
  void bindBase(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
                const EditedMaterial& material);
  void bindTable(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
                 const EditedMaterial& material);
  void bindLobe(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program,
                const std::shared_ptr<const TabulatedDensity>& lobe);

  std::shared_ptr<const TableTexture> tableTexture_;
  std::shared_ptr<ShaderBase> shaderBase_;
  std::unique_ptr<TextureSet> lobeTextures_;
  EditChain editChain_;
  BlendTextures blendTextures_;
  std::shared_ptr<const Brdf> uploadedBase_;
  std::shared_ptr<const TabulatedDensity> uploadedLobe_;
};

}  // namespace gonio::widgets
