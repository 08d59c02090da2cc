// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/incidence_table_brdf.h"
#include "core/brdf/rgl_brdf.h"
#include "core/brdf/utia_brdf.h"
#include "widgets/preview/gl/shader_base.h"
#include "widgets/preview/gl/textures.h"

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
