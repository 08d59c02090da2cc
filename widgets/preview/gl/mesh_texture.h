// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <span>

#include "core/rendering/shape.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

/// The triangles of a scene's meshes with one hierarchy of bounding volumes, on the graphics card, for
/// shaders/preview/scene_meshes.glsl: about 130 bytes per triangle.
class MeshTexture {
 public:
  /// Limited by the texture height that every card supports (16384 rows) and by memory.
  static constexpr std::size_t maxTriangles = 2'000'000;

  /// Builds the hierarchy and uploads it, in about 1 s per million triangles. Needs at least one mesh.
  /// @throws Error if there is not enough memory for the bounding volumes.
  MeshTexture(QOpenGLFunctions_4_1_Core& gl, std::span<const rendering::MeshShape> meshes);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program);

 private:
  TextureSet texture_;
  int triangles_ = 0, normals_ = 0;
};

}  // namespace gonio::widgets
