// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "core/geometry/mesh_intersector.h"
#include "core/rendering/ray.h"

namespace gonio {

/// A ball; its outside is the surface.
struct Sphere {
  Direction centre{0};
  double radius = 1;
};

/// A flat rectangle, seen from its front alone: the side that halfU x halfV points to. The half sides are
/// perpendicular.
struct Rectangle {
  Direction centre{0};
  Direction halfU{1, 0, 0}, halfV{0, 1, 0};

  Direction normal() const { return glm::normalize(glm::cross(halfU, halfV)); }
  double area() const { return 4 * glm::length(glm::cross(halfU, halfV)); }
  /// The point at (u, v) in [-1, 1]^2.
  Direction at(double u, double v) const { return centre + u * halfU + v * halfV; }
};

/// A mesh with what its rays need.
using MeshShape = std::shared_ptr<const MeshIntersector>;

/// The form of one object, in world coordinates (y up). All block light from both sides.
using Shape = std::variant<Sphere, Rectangle, MeshShape>;

/// Where a ray meets a shape. Normals are unit vectors in the world, away from the surface.
struct ShapeHit {
  double distance;
  Direction position, geometricNormal, shadingNormal;
};

/// The nearest meeting with t in (tMin, tMax): distance alone, for most shapes that a ray passes are not the nearest.
/// Infinity where there is none.
double nearestDistance(const Shape& shape, const Ray& ray, double tMin, double tMax);
/// The hit at a distance that nearestDistance() found from tMin = 0.
ShapeHit shapeHit(const Shape& shape, const Ray& ray, double distance);
/// The nearest hit at t > 0, where there is one.
std::optional<ShapeHit> nearestHit(const Shape& shape, const Ray& ray);
/// Where rays start that leave the surface on the side of the geometric normal: off it by more than rounding, so that
/// they do not meet it again where it is convex.
Direction leavingPoint(const Shape& shape, const ShapeHit& hit);
/// Whether the shape is met at a t in (tMin, tMax).
bool blocks(const Shape& shape, const Ray& ray, double tMin, double tMax);

/// Support function: the largest `direction` . x over the shape's points x. O(1); of a mesh O(vertices).
double support(const Shape& shape, const Direction& direction);
/// The point that attains it.
Direction supportPoint(const Shape& shape, const Direction& direction);
/// A sphere about the whole shape.
Sphere boundingSphere(const Shape& shape);
/// Whether no ray that leaves the surface, on the side of the normal, meets the shape again.
bool isConvex(const Shape& shape);
/// Whether the point certainly lies inside the shape, so that its outside turns away from it everywhere.
bool encloses(const Shape& shape, const Direction& point);

}  // namespace gonio
