// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/surface.h"

#include <array>
#include <cmath>

#include "core/geometry/bundled_meshes.h"
#include "core/photograph/photograph.h"

namespace gonio::photograph {

namespace {

using rendering::Overloaded;

constexpr double minLength = 1e-3, maxLength = 1e4;

/// The nearest intersection of a ray with a cylinder without ends; of rays beside it, the nearest point of the
/// silhouette.
struct CylinderHit {
  double offset;  ///< distance of the ray from the axis
  Direction normal;
  double along;  ///< place along the axis
  bool isInFront;

  CylinderHit(const Cylinder& cylinder, const Ray& ray) {
    const double originAlong = glm::dot(ray.origin, cylinder.axis),
                 directionAlong = glm::dot(ray.direction, cylinder.axis);
    const Direction origin = ray.origin - originAlong * cylinder.axis,
                    direction = ray.direction - directionAlong * cylinder.axis;
    const double square = glm::dot(direction, direction), middle = -glm::dot(origin, direction) / square;
    offset = glm::length(origin + middle * direction);
    const double t = middle - std::sqrt(std::max(0.0, 1 - offset * offset) / square);
    normal = glm::normalize(origin + t * direction);
    along = originAlong + t * directionAlong;
    isInFront = t > 0;
  }
};

constexpr int roundSegments = 512;

rendering::Shape meshShape(geometry::TriangleMesh mesh) {
  return std::make_shared<const geometry::MeshIntersector>(
      std::make_shared<const geometry::TriangleMesh>(std::move(mesh)));
}

rendering::Shape cylinderShape(const Cylinder& cylinder) {
  const double half = cylinder.length / 2;
  const std::array<glm::dvec2, 4> profile{{{0, -half}, {1, -half}, {1, half}, {0, half}}};
  const auto [z, x, y] = rendering::anyFrame(cylinder.axis);
  return meshShape(geometry::transformed(geometry::revolvedMesh(profile, roundSegments), glm::dmat3(x, y, z)));
}

rendering::Shape flatShape(const FlatSample& flat) {
  const auto [right, up, normal] = rendering::shadingFrame(flat.normal);
  const Direction u = flat.width / 2 * right, v = flat.height / 2 * up;
  if (!flat.isRound) return rendering::Rectangle{Direction(0), u, v};
  geometry::MeshArrays mesh{.positions = {glm::vec3(0)}, .triangles = {}, .normals = {}};
  for (std::uint32_t i = 0; i < roundSegments; ++i) {
    const double angle = 2 * pi * i / roundSegments;
    mesh.positions.emplace_back(std::cos(angle) * u + std::sin(angle) * v);
    mesh.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % roundSegments);
  }
  return meshShape(geometry::TriangleMesh(std::move(mesh)));
}

/// Place on a flat sample in units of its half sides.
glm::dvec2 placeOn(const FlatSample& flat, const Direction& point) {
  const Direction local = rendering::shadingFrame(flat.normal).toLocal(point);
  return {2 * local.x / flat.width, 2 * local.y / flat.height};
}

bool isOn(const FlatSample& flat, const Direction& point, double fraction) {
  const glm::dvec2 place = placeOn(flat, point);
  return flat.isRound ? glm::length(place) <= fraction : std::abs(place.x) <= fraction && std::abs(place.y) <= fraction;
}

}  // namespace

std::string_view surfaceName(const Surface& surface) {
  return std::visit(Overloaded{[](const UnitSphere&) { return "sphere"; }, [](const Cylinder&) { return "cylinder"; },
                               [](const FlatSample&) { return "flat sample"; }},
                    surface);
}

Direction readDirection(const JsonObject& object, std::string_view key) {
  const auto [x, y, z] = object.triple(key);
  const Direction direction{x, y, z};
  if (!(glm::length(direction) > 0)) object.fail(key, "a direction, not [0, 0, 0]");
  return glm::normalize(direction);
}

Surface readSurface(const JsonObject& image) {
  if (!image.contains("shape")) return UnitSphere{};
  const char* expected = "{\"cylinder\": {..}} or {\"flat\": {..}}; without \"shape\", a sphere";
  const nlohmann::json& member = image.member("shape", expected);
  if (!member.is_object() || member.size() != 1 || !(member.contains("cylinder") || member.contains("flat")))
    image.fail("shape", expected);
  const JsonObject shape = image.object("shape");
  if (shape.contains("cylinder")) {
    const JsonObject json = shape.object("cylinder");
    json.expectOnly({"axis", "length"});
    return Cylinder{readDirection(json, "axis"), json.number("length", minLength, maxLength)};
  }
  const JsonObject json = shape.object("flat");
  FlatSample flat{.normal = readDirection(json, "normal")};
  if (json.contains("radius")) {
    json.expectOnly({"normal", "radius"});
    flat.width = flat.height = 2 * json.number("radius", minLength, maxLength);
    flat.isRound = true;
    return flat;
  }
  json.expectOnly({"normal", "width", "height", "radius"});
  flat.width = json.number("width", minLength, maxLength);
  flat.height = json.number("height", minLength, maxLength);
  return flat;
}

rendering::Shape renderedShape(const Surface& surface) {
  return std::visit(Overloaded{[](const UnitSphere&) { return rendering::Shape(rendering::Sphere{}); },
                               [](const Cylinder& of) { return cylinderShape(of); },
                               [](const FlatSample& of) { return flatShape(of); }},
                    surface);
}

bool isOutside(const Surface& surface, const Direction& point) {
  return std::visit(Overloaded{[&](const UnitSphere&) { return glm::length(point) > 1; },
                               [&](const Cylinder& of) { return glm::length(glm::cross(point, of.axis)) > 1; },
                               [&](const FlatSample& of) { return glm::dot(point, of.normal) > 0; }},
                    surface);
}

bool occupies(const Surface& surface, const Direction& point) {
  return std::visit(Overloaded{[&](const UnitSphere&) { return !(glm::length(point) > 1); },
                               [&](const Cylinder& of) {
                                 return glm::length(glm::cross(point, of.axis)) <= 1 &&
                                        std::abs(glm::dot(point, of.axis)) <= of.length / 2;
                               },
                               [&](const FlatSample& of) {
                                 constexpr double thickness = 1e-6;  // of the larger side
                                 return isOn(of, point, 1) && std::abs(glm::dot(point, of.normal)) <=
                                                                  thickness * std::max(of.width, of.height);
                               }},
                    surface);
}

ImagePlane imagePlane(const Photograph& photograph) {
  if (isSphere(photograph.surface)) {
    const double distance = photograph.camera.distance;
    return {{photograph.disc.x, photograph.disc.y}, 1 / std::sqrt(distance * distance - 1) / photograph.disc.radius};
  }
  const glm::dvec2 size(photograph.size);
  return {0.5 * size, 2 * std::tan(photograph.camera.fieldOfView / 2) / std::min(size.x, size.y)};
}

SurfaceView::SurfaceView(const Photograph& photograph)
    : surface_(photograph.surface),
      frame_(rendering::cameraFrame(photograph.camera)),
      plane_(imagePlane(photograph)),
      outline_(photograph.disc.radius) {}

Ray SurfaceView::ray(const glm::dvec2& pixel) const {
  const glm::dvec2 offset = plane_.perPixel * (pixel - plane_.centre);
  return {frame_.eye, glm::normalize(frame_.forward + offset.x * frame_.right - offset.y * frame_.up)};
}

SeenPoint SurfaceView::at(const glm::dvec2& pixel) const {
  const Ray seen = ray(pixel);
  const auto seenAt = [&](double t) { return seen.origin + t * seen.direction; };
  return std::visit(
      Overloaded{[&](const UnitSphere&) {
                   const double middle = -glm::dot(seen.origin, seen.direction);
                   const double square = middle * middle - (glm::dot(seen.origin, seen.origin) - 1);
                   const Direction normal = glm::normalize(seenAt(middle - std::sqrt(std::max(0.0, square))));
                   return SeenPoint{normal, normal, -seen.direction};
                 },
                 [&](const Cylinder& of) {
                   const CylinderHit hit(of, seen);
                   return SeenPoint{hit.normal + hit.along * of.axis, hit.normal, -seen.direction};
                 },
                 [&](const FlatSample& of) {
                   const double t = -glm::dot(seen.origin, of.normal) / glm::dot(seen.direction, of.normal);
                   return SeenPoint{seenAt(t), of.normal, -seen.direction};
                 }},
      surface_);
}

bool SurfaceView::shows(const glm::dvec2& pixel, double fraction) const {
  return std::visit(
      Overloaded{[&](const UnitSphere&) { return glm::length(pixel - plane_.centre) <= fraction * outline_; },
                 [&](const Cylinder& of) {
                   const CylinderHit hit(of, ray(pixel));
                   return hit.isInFront && hit.offset <= fraction && std::abs(hit.along) <= fraction * of.length / 2;
                 },
                 [&](const FlatSample& of) {
                   const SeenPoint point = at(pixel);
                   return glm::dot(point.toViewer, of.normal) > 0 && isOn(of, point.position, fraction);
                 }},
      surface_);
}

}  // namespace gonio::photograph
