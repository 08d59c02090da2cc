// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace gonio::rendering {

namespace {

constexpr double noHit = std::numeric_limits<double>::infinity();

double nearest(const Sphere& sphere, const Ray& ray, double tMin, double tMax) {
  const Direction toOrigin = ray.origin - sphere.centre;
  const double middle = -glm::dot(toOrigin, ray.direction);
  // The squared distance of the ray from the centre: no cancellation however far the origin is.
  const Direction closest = toOrigin + middle * ray.direction;
  const double half2 = sphere.radius * sphere.radius - glm::dot(closest, closest);
  if (!(half2 > 0)) return noHit;
  const double half = std::sqrt(half2);
  for (const double t : {middle - half, middle + half})
    if (t > tMin && t < tMax) return t;
  return noHit;
}

double nearest(const Rectangle& rectangle, const Ray& ray, double tMin, double tMax) {
  const Direction normal = glm::cross(rectangle.halfU, rectangle.halfV);
  const double slope = glm::dot(normal, ray.direction);
  if (slope == 0) return noHit;
  const double t = glm::dot(normal, rectangle.centre - ray.origin) / slope;
  if (!(t > tMin && t < tMax)) return noHit;
  const Direction offset = ray.origin + t * ray.direction - rectangle.centre;
  const bool inside = std::abs(glm::dot(offset, rectangle.halfU)) <= glm::dot(rectangle.halfU, rectangle.halfU) &&
                      std::abs(glm::dot(offset, rectangle.halfV)) <= glm::dot(rectangle.halfV, rectangle.halfV);
  return inside ? t : noHit;
}

double nearest(const MeshShape& mesh, const Ray& ray, double tMin, double tMax) {
  const auto hit = mesh->closest(ray.origin, ray.direction, tMin, tMax);
  return hit ? hit->t : noHit;
}

Direction farthestVertex(const geometry::TriangleMesh& mesh, const Direction& direction) {
  const auto along = [&](const glm::vec3& vertex) { return glm::dot(Direction(vertex), direction); };
  return Direction(*std::ranges::max_element(mesh.positions(), {}, along));
}

double sign(double x) { return x < 0 ? -1 : 1; }

}  // namespace

double nearestDistance(const Shape& shape, const Ray& ray, double tMin, double tMax) {
  return std::visit([&](const auto& form) { return nearest(form, ray, tMin, tMax); }, shape);
}

ShapeHit shapeHit(const Shape& shape, const Ray& ray, double t) {
  assert(std::isfinite(t));
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    const auto hit = (*mesh)->closest(ray.origin, ray.direction, 0, noHit);
    assert(hit);
    return {hit->t, hit->position, hit->geometricNormal, hit->shadingNormal};
  }
  const Direction position = ray.origin + t * ray.direction;
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    const Direction normal = glm::normalize(position - sphere->centre);
    return {t, sphere->centre + sphere->radius * normal, normal, normal};
  }
  const auto& rectangle = std::get<Rectangle>(shape);
  const Direction normal = rectangle.normal();
  // From far away the ray's end is not in the plane by much more than the coordinates' rounding.
  return {t, position - glm::dot(position - rectangle.centre, normal) * normal, normal, normal};
}

std::optional<ShapeHit> nearestHit(const Shape& shape, const Ray& ray) {
  const double distance = nearestDistance(shape, ray, 0, noHit);
  if (!std::isfinite(distance)) return std::nullopt;
  return shapeHit(shape, ray, distance);
}

Direction offsetRayOrigin(const Shape& shape, const ShapeHit& hit) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape))
    return geometry::offsetOrigin(hit.position, hit.geometricNormal, (*mesh)->mesh().boundingSphere().radius);
  const Sphere bound = boundingSphere(shape);
  const double maxCoordinate = glm::length(bound.centre) + bound.radius;
  return hit.position + 16 * std::numeric_limits<double>::epsilon() * maxCoordinate * hit.geometricNormal;
}

bool blocks(const Shape& shape, const Ray& ray, double tMin, double tMax) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape))
    return (*mesh)->occluded(ray.origin, ray.direction, tMin, tMax);
  return std::isfinite(nearestDistance(shape, ray, tMin, tMax));
}

Direction supportPoint(const Shape& shape, const Direction& d) {
  return std::visit(Overloaded{[&](const Sphere& sphere) { return sphere.centre + sphere.radius * glm::normalize(d); },
                               [&](const Rectangle& rectangle) {
                                 return rectangle.at(sign(glm::dot(rectangle.halfU, d)),
                                                     sign(glm::dot(rectangle.halfV, d)));
                               },
                               [&](const MeshShape& mesh) { return farthestVertex(mesh->mesh(), d); }},
                    shape);
}

double support(const Shape& shape, const Direction& direction) {
  return glm::dot(supportPoint(shape, direction), direction);
}

Sphere boundingSphere(const Shape& shape) {
  return std::visit(Overloaded{[](const Sphere& sphere) { return sphere; },
                               [](const Rectangle& rectangle) {
                                 return Sphere{rectangle.centre, glm::length(rectangle.halfU + rectangle.halfV)};
                               },
                               [](const MeshShape& mesh) {
                                 const geometry::TriangleMesh::Sphere& bound = mesh->mesh().boundingSphere();
                                 return Sphere{bound.centre, bound.radius};
                               }},
                    shape);
}

bool isConvex(const Shape& shape) {
  const auto* mesh = std::get_if<MeshShape>(&shape);
  return !mesh || (*mesh)->mesh().isConvex() || (*mesh)->mesh().isPlanar();
}

bool encloses(const Shape& shape, const Direction& point) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return glm::length(point - sphere->centre) < sphere->radius;
  const auto* intersector = std::get_if<MeshShape>(&shape);
  if (!intersector || !(*intersector)->mesh().isConvex()) return false;
  const geometry::TriangleMesh& mesh = (*intersector)->mesh();
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const Direction corner(mesh.positions()[mesh.triangles()[i][0]]);
    if (!(glm::dot(mesh.geometricNormal(i), point - corner) < 0)) return false;
  }
  return true;
}

}  // namespace gonio::rendering
