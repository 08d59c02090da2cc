// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/incidence_table_brdf.h"
#include "widgets/preview/gl/shader_base.h"
#include "widgets/preview/gl/warp_textures.h"

namespace gonio::widgets {

/// A table of angles of incidence on the graphics card, for shaders/preview/incidence_table.glsl: 16 bytes a value.
class IncidenceTextures final : public ShaderBase {
 public:
  /// Uploads; some ms.
  IncidenceTextures(QOpenGLFunctions_4_1_Core& gl, const IncidenceTableBrdf& brdf);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) override;

  /// Whether the least that OpenGL 4.1 asks of textures holds the table: 2,048 nodes of each angle.
  static bool fits(const IncidenceTable& table);
  /// What the shader is compiled for.
  static QStringList definitions(const IncidenceTable& table);

 private:
  GLint counts_[3];  ///< of polar angles, azimuths, angles of incidence
  TextureSet textures_;
};

}  // namespace gonio::widgets
