// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "widgets/preview/gl/shader_base.h"
#include "widgets/preview/gl/warp_textures.h"

namespace gonio::widgets {

/// An RGL file on the graphics card, for shaders/preview/rgl.glsl: about 1.5 MB for one of the database.
class RglTextures final : public ShaderBase {
 public:
  /// Uploads the tables, in a few ms.
  RglTextures(QOpenGLFunctions_4_1_Core& gl, std::shared_ptr<const RglBrdf::Tables> tables);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) override;

  /// The definitions of the shader variant, without the incident direction.
  static QStringList definitions(const RglBrdf& brdf);

 private:
  std::shared_ptr<const RglBrdf::Tables> tables_;
  TextureSet warp_, others_;
};

}  // namespace gonio::widgets
