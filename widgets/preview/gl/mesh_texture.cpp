// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/mesh_texture.h"

#include <bit>
#include <glm/vec4.hpp>

#include "core/geometry/mesh_intersector.h"

namespace gonio::widgets {

namespace {

constexpr int rowBits = 11;              // of scene_meshes.glsl
constexpr std::uint32_t emptyChild = 7;  // likewise
using Texels = std::vector<glm::uvec4>;  // of 32 bits, for floats and numbers

struct Triangle {
  std::uint32_t mesh;
  glm::vec3 corners[3], normals[3];
};

std::vector<Triangle> trianglesOf(std::span<const rendering::MeshShape> meshes) {
  std::vector<Triangle> all;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const geometry::TriangleMesh& mesh = meshes[i]->mesh();
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
      Triangle& triangle = all.emplace_back();
      triangle.mesh = std::uint32_t(i);
      for (int corner = 0; corner < 3; ++corner) {
        triangle.corners[corner] = mesh.positions()[mesh.triangles()[t][corner]];
        triangle.normals[corner] = mesh.cornerNormals()[3 * t + std::size_t(corner)];
      }
    }
  }
  return all;
}

geometry::AxisBox boxOf(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

glm::uvec4 texel(const glm::vec3& v, std::uint32_t number = 0) {
  return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y), std::bit_cast<std::uint32_t>(v.z),
          number};
}

/// 4 texels: low and high corner of each child's box; beside the low one, where the child is.
void addNode(Texels& texels, const geometry::BoundingVolumes::Node& node) {
  for (const geometry::BoundingVolumes::Child& child : node.children) {
    const bool isEmpty = child.count == 0 && child.first == 0;
    texels.push_back(texel(child.box.min, child.first << 3 | (isEmpty ? emptyChild : child.count)));
    texels.push_back(texel(child.box.max));
  }
}

/// Nodes; 3 texels a triangle: a corner with the mesh's number, the edges from it; 3 a triangle: the corners' normals.
struct Layout {
  Texels texels;
  int triangles = 0, normals = 0;

  explicit Layout(std::span<const rendering::MeshShape> meshes) {
    const std::vector<Triangle> all = trianglesOf(meshes);
    std::vector<geometry::AxisBox> boxes;
    boxes.reserve(all.size());
    for (const Triangle& triangle : all) boxes.push_back(boxOf(triangle));
    const geometry::BoundingVolumes volumes = geometry::buildBoundingVolumes(boxes);
    for (const geometry::BoundingVolumes::Node& node : volumes.nodes) addNode(texels, node);
    triangles = int(texels.size());
    for (const std::uint32_t index : volumes.order) {
      const auto& [a, b, c] = all[index].corners;
      texels.insert(texels.end(), {texel(a, all[index].mesh), texel(b - a), texel(c - a)});
    }
    normals = int(texels.size());
    for (const std::uint32_t index : volumes.order)
      for (const glm::vec3& normal : all[index].normals) texels.push_back(texel(normal));
  }
};

}  // namespace

MeshTexture::MeshTexture(QOpenGLFunctions_4_1_Core& gl, std::span<const rendering::MeshShape> meshes) {
  Layout layout(meshes);
  constexpr std::size_t width = std::size_t(1) << rowBits;
  const std::size_t rows = (layout.texels.size() + width - 1) / width;
  layout.texels.resize(width * rows);
  triangles_ = layout.triangles;
  normals_ = layout.normals;
  texture_.bind(gl, 0, GL_TEXTURE_2D, meshUnit);
  gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, GLsizei(width), GLsizei(rows), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                  layout.texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
}

void MeshTexture::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) {
  texture_.bind(gl, 0, GL_TEXTURE_2D, meshUnit);
  program.setUniformValue("meshTexels", meshUnit);
  program.setUniformValue("meshTriangles", triangles_);
  program.setUniformValue("meshNormals", normals_);
}

}  // namespace gonio::widgets
