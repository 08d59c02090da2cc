// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/utia_brdf.h"
#include "widgets/preview/gl/shader_base.h"
#include "widgets/preview/gl/warp_textures.h"

namespace gonio::widgets {

/// A UTIA material on the graphics card, for shaders/preview/utia.glsl: 288 x 288 texels of RGBA32F, 1.3 MB.
class UtiaTexture final : public ShaderBase {
 public:
  /// Uploads the values, in about 1 ms.
  UtiaTexture(QOpenGLFunctions_4_1_Core& gl, const UtiaBrdf::Values& values);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) override;

  /// The definitions of the shader variant, without the incident direction.
  static QStringList definitions() { return {"UTIA"}; }

 private:
  TextureSet texture_;
};

}  // namespace gonio::widgets
