// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string_view>
#include <variant>

#include "core/matching/sphere_finder.h"
#include "core/rendering/scene.h"
#include "core/support/json_object.h"

/// The surfaces that a material covers in photographs, and what a camera sees of them. Their middle is the origin of
/// the world. All are convex: nothing but the horizon of its normal shadows a point.
namespace gonio::photograph {

struct Photograph;

/// A sphere of radius 1.
struct UnitSphere {};

/// A cylinder of radius 1, of which the side is photographed.
struct Cylinder {
  Direction axis{0, 1, 0};  ///< world, unit
  double length = 2;
};

/// A flat sample, of which the front is photographed, in any unit of length. Width and height are along the tangent and
/// the bitangent of rendering::shadingFrame(): the width is horizontal.
struct FlatSample {
  Direction normal{0, 0, 1};  ///< of the front: world, unit
  double width = 2, height = 2;
  bool isRound = false;  ///< an ellipse of this size instead of a rectangle
};

using Surface = std::variant<UnitSphere, Cylinder, FlatSample>;

/// "sphere", "cylinder" or "flat sample".
std::string_view surfaceName(const Surface& surface);
inline bool isSphere(const Surface& surface) { return std::holds_alternative<UnitSphere>(surface); }

/// The surface of an entry of a description: its member "shape", or a sphere without it. @throws Error that names the
/// member.
Surface readSurface(const JsonObject& image);
/// A member with a direction of any length. @return unit. @throws Error that names the member.
Direction readDirection(const JsonObject& object, std::string_view key);

/// The solid or the flat piece that a renderer shows. Cylinders (with their caps) and round samples are meshes of 512
/// segments.
rendering::Shape renderedShape(const Surface& surface);
/// Whether a camera at a point sees the surface from outside: beyond the radius of a sphere or of a cylinder, or in
/// front of a flat sample.
bool isOutside(const Surface& surface, const Direction& point);
/// Whether a small light cannot be at a point: inside a sphere or a cylinder, or in a flat sample.
bool occupies(const Surface& surface, const Direction& point);

/// Where a pixel without a stated outline is relative to the axis of the camera.
struct ImagePlane {
  glm::dvec2 centre{0};  ///< the pixel on the axis
  double perPixel = 0;   ///< tangent of the angle of a pixel on the axis
};
/// That of a photograph: by the outline of a sphere, by the field of view of the camera for other surfaces.
ImagePlane imagePlane(const Photograph& photograph);

/// A point of a surface that a camera sees: world coordinates.
struct SeenPoint {
  Direction position;
  Direction normal, toViewer;  ///< unit
};

/// What the places of a photograph show.
class SurfaceView {
 public:
  explicit SurfaceView(const Photograph& photograph);

  /// The point at a place. Beside the surface, but inside the silhouette of a cylinder without ends or on the plane of
  /// a flat sample, it is a point of these; beside a sphere, the nearest one of its silhouette.
  SeenPoint at(const glm::dvec2& pixel) const;
  /// Whether a place shows the surface. @param fraction 1: anywhere; below 1: up to this fraction of the radius of the
  /// silhouette of a sphere or a cylinder, and of the half length or half sides.
  bool shows(const glm::dvec2& pixel, double fraction = 1) const;

 private:
  Ray ray(const glm::dvec2& pixel) const;

  Surface surface_;
  rendering::CameraFrame frame_;
  ImagePlane plane_;
  double outline_;  ///< radius of the outline of a sphere, pixels
};

}  // namespace gonio::photograph
