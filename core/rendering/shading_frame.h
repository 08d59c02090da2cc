// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/math/types.h"

namespace gonio {

/// The local frame at a point of a surface.
struct ShadingFrame {
  Direction tangent, bitangent, normal;  ///< world, orthonormal, right-handed

  Direction toLocal(const Direction& world) const {
    return {glm::dot(world, tangent), glm::dot(world, bitangent), glm::dot(world, normal)};
  }
  Direction toWorld(const Direction& local) const { return local.x * tangent + local.y * bitangent + local.z * normal; }
};

/// The frame of anisotropic materials on spheres and meshes: `tangent` is in the direction of the right-handed rotation
/// about +y (to the right, seen from outside), `bitangent` = normal x tangent (upward, seen from outside); at the poles
/// the tangent is +x.
inline ShadingFrame shadingFrame(const Direction& normal) {
  const double radius = std::sqrt(normal.x * normal.x + normal.z * normal.z);
  const Direction tangent = radius > 0 ? Direction{normal.z / radius, 0, -normal.x / radius} : Direction{1, 0, 0};
  return {tangent, glm::cross(normal, tangent), normal};
}

/// A frame with arbitrary tangent, for isotropic materials (Duff et al. 2017, "Building an Orthonormal Basis,
/// Revisited").
inline ShadingFrame anyFrame(const Direction& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace gonio
