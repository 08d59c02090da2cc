// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <memory>
#include <random>

#include "core/geometry/bundled_meshes.h"

namespace gonio::test {

/// The cube [-1, 1]^3, 8 vertices, wound outward, without normals.
inline geometry::MeshArrays cubeArrays() {
  geometry::MeshArrays arrays;
  for (int i = 0; i < 8; ++i) arrays.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  const std::uint32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& f : faces) {
    arrays.triangles.emplace_back(f[0], f[1], f[2]);
    arrays.triangles.emplace_back(f[0], f[2], f[3]);
  }
  return arrays;
}

/// A sphere about the origin.
inline geometry::TriangleMesh sphereMesh(double radius, int rings, int segments) {
  std::vector<glm::dvec2> profile;
  for (int i = 0; i <= rings; ++i)
    profile.emplace_back(radius * std::sin(pi * i / rings), radius * std::cos(pi * i / rings));
  profile.front().x = profile.back().x = 0;
  return geometry::revolvedMesh(profile, segments);
}

inline std::shared_ptr<const geometry::TriangleMesh> shared(geometry::TriangleMesh mesh) {
  return std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
}

/// Even over the sphere.
inline Direction randomDirection(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double z = 1 - 2 * uniform(random);
  return fromSpherical(std::acos(z), 2 * pi * uniform(random));
}

}  // namespace gonio::test
