// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/incidence_table_brdf.h"
#include "widgets/preview/gl/shader_base.h"
#include "widgets/preview/gl/warp_textures.h"

namespace gonio::widgets {

/// A table by angle of incidence on the graphics card, for shaders/preview/incidence_table.glsl: 16 bytes per value.
class IncidenceTextures final : public ShaderBase {
 public:
  /// Uploads the table, in a few ms.
  IncidenceTextures(QOpenGLFunctions_4_1_Core& gl, const IncidenceTableBrdf& brdf);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) override;

  /// Whether the table fits the texture size that OpenGL 4.1 guarantees: 2,048 nodes per angle.
  static bool fits(const IncidenceTable& table);
  /// The definitions of the shader variant.
  static QStringList definitions(const IncidenceTable& table);

 private:
  GLint counts_[3];  ///< numbers of polar angles, azimuths and angles of incidence
  TextureSet textures_;
};

}  // namespace gonio::widgets
