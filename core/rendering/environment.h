// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/math/image.h"
#include "core/rendering/environment_density.h"

namespace gonio::rendering {

/// Infinitely distant light, as a latitude-longitude map of linear RGB radiance. World axes: x right, y up; the default
/// camera looks along -z. The position (u, v) in [0, 1]^2, v = 0 at the top, has the direction
///   (sin theta sin a, cos theta, -sin theta cos a), theta = pi v, a = 2 pi (u - 1/2):
/// The centre column is straight ahead of the camera (-z), the azimuth a increases from there toward +x, to the right,
/// and the left and right edges meet behind the camera (+z). The centre of pixel (x, y) is at u = (x + 1/2) / width, v
/// = (y + 1/2) / height. Immutable.
class EnvironmentMap {
 public:
  /// Negative values become 0 and are counted in the notes. @param notes what a reader changed. @throws Error if the
  /// map is empty, or a value is not finite (the message names the first such pixel).
  explicit EnvironmentMap(Image radiance, std::string name, std::vector<std::string> notes = {});

  const std::string& name() const { return name_; }
  /// What was changed or is unusual, for people: converted colours, negative values, another shape than 2:1.
  const std::vector<std::string>& notes() const { return notes_; }
  const Image& image() const { return image_; }

  /// Radiance from a world direction (unit), bilinear between pixel centres, wrapped in azimuth.
  Rgb radiance(const Direction& world) const;

  struct Sample {
    Direction direction;  ///< world
    Rgb radiance;
    double pdf;  ///< 1/sr
  };
  /// Samples a direction with a density proportional to the bilinear luminance (EnvironmentDensity); 1 / (4 pi) for a
  /// black map. @param u1, u2 in [0, 1), for row and column.
  Sample sample(double u1, double u2) const;
  /// Samples a direction that illuminates a surface: proportional to the luminance and about to the cosine. Density and
  /// radiance are 0 if the direction is below the horizon of the normal (world).
  Sample sampleAbove(const Direction& normal, double u1, double u2) const;
  /// Density of sample(), 1/sr.
  double pdf(const Direction& world) const { return at(world).pdf; }
  /// Radiance and density of one direction; faster than two calls.
  Sample at(const Direction& world) const;
  /// The same with the density of sampleAbove(). Precondition: the direction is above the horizon of the normal.
  Sample atAbove(const Direction& normal, const Direction& world) const;

  /// The mapping from a position (u, v) in [0, 1]^2, v = 0 at the top, to a world direction, and its inverse. The
  /// shader implements the same mapping.
  static Direction directionAt(double u, double v);
  static glm::dvec2 positionOf(const Direction& world);

 private:
  Sample at(EnvironmentDensity::Table table, const Direction& world) const;
  Rgb bilinear(const glm::dvec2& position) const;
  Sample sampled(const EnvironmentDensity::Sample& sample, const Direction& world) const;

  Image image_;
  std::string name_;
  std::vector<std::string> notes_;
  std::shared_ptr<const EnvironmentDensity> density_;
};

/// Rotation of an environment about the vertical axis, clockwise seen from above (opposite to OrbitCamera::yaw):
/// converts a world direction to a direction of the unrotated environment, and back. With c, s the cosine and sine of
/// the angle (rad): (x c + z s, y, z c - x s). Positive angles rotate the environment from -z toward +x.
class EnvironmentRotation {
 public:
  explicit EnvironmentRotation(double angle);
  Direction toEnvironment(const Direction& w) const { return {w.x * c_ + w.z * s_, w.y, w.z * c_ - w.x * s_}; }
  Direction fromEnvironment(const Direction& w) const { return {w.x * c_ - w.z * s_, w.y, w.z * c_ + w.x * s_}; }

 private:
  double c_, s_;
};

/// The bundled environments, computed by code, 512 x 256: "studio" (soft boxes), "rim-lights" (the studio with strips
/// of light behind the object, which outline dark materials), "sky" (clear, with a sun), "sunset" (a low warm sun in
/// haze), "window" (a dim room with a window and a lamp), "furnace" (radiance 1 everywhere).
const std::vector<std::string>& bundledEnvironmentNames();
/// The names, separated by commas.
std::string bundledEnvironmentList();
/// The environment of a name, computed at the first call, then shared. @throws Error that lists the names.
std::shared_ptr<const EnvironmentMap> bundledEnvironment(const std::string& name);
std::shared_ptr<const EnvironmentMap> studioEnvironment();
std::shared_ptr<const EnvironmentMap> skyEnvironment();
std::shared_ptr<const EnvironmentMap> furnaceEnvironment();

/// A bundled environment by its name, or a latitude-longitude map from a file (HDR or EXR, io::readImageFile()).
/// @param folder base of relative paths; empty: the current folder.
/// @throws Error that names the file and its fault, if it is neither, or a map that Gonio wrote in another layout.
std::shared_ptr<const EnvironmentMap> openEnvironment(const std::string& nameOrPath,
                                                      const std::filesystem::path& folder = {});

/// Size of a blurred environment in pixels: 2.8 degrees per pixel.
inline constexpr int blurredWidth = 128, blurredHeight = 64;
/// Concentration of the blur kernel, a von Mises-Fisher distribution proportional to exp(concentration cos angle): 1 /
/// variance, for a standard deviation of 6 degrees along each tangent.
inline constexpr double blurConcentration = 91.2;

/// The environment as a background out of focus, which does not illuminate objects: its radiance convolved on the
/// sphere with the kernel above, cut off at 20 degrees. Constants are preserved. Computed once in the lifetime of the
/// environment (about 0.1 s); callable from several threads. @param environment not null.
std::shared_ptr<const EnvironmentMap> blurredEnvironment(const std::shared_ptr<const EnvironmentMap>& environment);

}  // namespace gonio::rendering
