// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <variant>

#include "core/geometry/mesh_intersector.h"
#include "core/math/types.h"

namespace gonio::rendering {

/// A sphere; only its outside reflects.
struct Sphere {
  Direction centre{0};
  double radius = 1;
};

/// A rectangle that reflects or emits only on its front, the side of halfU x halfV. The half sides must be
/// perpendicular.
struct Rectangle {
  Direction centre{0};
  Direction halfU{1, 0, 0}, halfV{0, 1, 0};

  Direction normal() const { return glm::normalize(glm::cross(halfU, halfV)); }
  double area() const { return 4 * glm::length(glm::cross(halfU, halfV)); }
  /// The point at (u, v) in [-1, 1]^2.
  Direction at(double u, double v) const { return centre + u * halfU + v * halfV; }
};

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

/// A visitor of a variant that has a function for each of its types.
template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

/// A mesh with its ray intersector.
using MeshShape = std::shared_ptr<const geometry::MeshIntersector>;

/// The shape of an object, in world coordinates (y up). All shapes block light from both sides.
using Shape = std::variant<Sphere, Rectangle, MeshShape>;

/// An intersection of a ray and a shape. Normals are unit vectors in world coordinates, outward.
struct ShapeHit {
  double distance;
  Direction position, geometricNormal, shadingNormal;
};

/// The distance of the nearest hit with t in (tMin, tMax); infinity if there is none. Faster than nearestHit(), to find
/// the nearest of several shapes.
double nearestDistance(const Shape& shape, const Ray& ray, double tMin, double tMax);
/// The hit at a distance that nearestDistance() found from tMin = 0.
ShapeHit shapeHit(const Shape& shape, const Ray& ray, double distance);
/// The nearest hit at t > 0, if any.
std::optional<ShapeHit> nearestHit(const Shape& shape, const Ray& ray);
/// The origin of rays that leave the surface on the side of the geometric normal, offset by more than the rounding
/// errors so that they do not hit a convex surface again (see offsetOrigin()).
Direction offsetRayOrigin(const Shape& shape, const ShapeHit& hit);
/// Whether the ray hits the shape at a t in (tMin, tMax).
bool blocks(const Shape& shape, const Ray& ray, double tMin, double tMax);

/// Support function: the largest `direction` . x over the points x of the shape. O(1); O(vertices) for a mesh.
double support(const Shape& shape, const Direction& direction);
/// The point at which the support function attains its maximum.
Direction supportPoint(const Shape& shape, const Direction& direction);
/// A sphere that contains the whole shape.
Sphere boundingSphere(const Shape& shape);
/// Whether no ray that leaves the surface on the side of the normal can hit the shape again.
bool isConvex(const Shape& shape);
/// Whether the point is certainly inside the shape, so that the outside of the shape faces away from it everywhere.
/// Conservative.
bool encloses(const Shape& shape, const Direction& point);

}  // namespace gonio::rendering
