// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <span>

#include "core/rendering/shape.h"
#include "widgets/preview/gl/warp_textures.h"

namespace gonio::widgets {

/// The triangles of a scene's meshes with one hierarchy of bounding volumes, on the graphics card, for
/// shaders/preview/scene_meshes.glsl: about 130 bytes a triangle.
class MeshTexture {
 public:
  /// What the largest texture that every card has (16384 rows) and its memory bear.
  static constexpr std::size_t maxTriangles = 2'000'000;

  /// Builds and uploads: about 1 s a million triangles. At least one mesh.
  /// @throws Error where the memory for the bounding volumes is missing.
  MeshTexture(QOpenGLFunctions_4_1_Core& gl, std::span<const MeshShape> meshes);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program);

 private:
  TextureSet texture_;
  int triangles_ = 0, normals_ = 0;
};

}  // namespace gonio::widgets
