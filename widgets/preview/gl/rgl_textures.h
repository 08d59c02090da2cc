// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLShaderProgram>
#include <QStringList>

#include "core/brdf/rgl_brdf.h"
#include "widgets/preview/gl/warp_textures.h"

namespace gonio::widgets {

/// An RGL file on the graphics card, for shaders/preview/rgl.glsl: about 1.5 MB for one of the database. Freed with its
/// last user, in whose hands the context must be current.
class RglTextures {
 public:
  /// Uploads; some ms.
  RglTextures(QOpenGLFunctions_4_1_Core& gl, const RglBrdf::Tables& tables);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, const RglBrdf::Tables& tables);

  /// What the shader is compiled for.
  static QStringList definitions(const RglBrdf& brdf);

 private:
  TextureSet warp_, others_;
};

}  // namespace gonio::widgets
