// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/math/image.h"

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
  /// Samples a direction. The density is constant over each pixel's solid angle (of maps above 8192 pixels wide, that
  /// of 2 x 2 pixels, above 16384 of 4 x 4, and so on) and proportional to the mean luminance of the bilinear radiance
  /// in it (1 / (4 pi) for a black map). @param u1, u2 in [0, 1), for row and column.
  Sample sample(double u1, double u2) const;
  /// The same, with density and radiance 0 if the direction is below the horizon of a normal (world).
  Sample sampleAbove(const Direction& normal, double u1, double u2) const;
  /// Density of sample(), 1/sr.
  double pdf(const Direction& world) const;
  /// Radiance and density of one direction; faster than two calls.
  Sample at(const Direction& world) const;

  /// The mapping from a position (u, v) in [0, 1]^2, v = 0 at the top, to a world direction, and its inverse. The
  /// shader implements the same mapping.
  static Direction directionAt(double u, double v);
  static glm::dvec2 positionOf(const Direction& world);

 private:
  /// The largest width of the sampling tables: of wider maps they would take as much memory as the map.
  static constexpr int maxTableWidth = 8192;

  /// The pixels of a block along a row.
  struct BlockColumns {
    int first, count;
    double fraction;  ///< of the row's width
  };
  BlockColumns columnsOf(std::size_t block) const;
  /// A block of pixels, and a direction through it.
  struct PixelDirection {
    std::size_t x, y;
    double u, cosTheta, sinTheta;
    Direction direction;
  };
  PixelDirection sampleDirection(double u1, double u2) const;
  Sample at(const PixelDirection& place) const;
  Rgb bilinear(const glm::dvec2& position) const;
  double blockPdf(std::size_t x, std::size_t y) const;
  std::vector<double> blockWeights(std::size_t row) const;
  void buildTables();

  Image image_;
  std::string name_;
  std::vector<std::string> notes_;
  int blockSide_ = 1;             ///< pixels; a power of two
  std::size_t blockColumns_ = 0;  ///< blocks of a row
  std::vector<double> cosEdges_;  ///< cos theta of the upper edges of rows of blocks, and of the last one's lower edge
  /// Cumulative distributions from 0 to 1: one of the rows of blocks, and for each of them that of its blocks.
  std::vector<float> marginal_, conditional_;
  std::vector<std::uint32_t> marginalGuide_, conditionalGuide_;  ///< start indices of searches in the tables
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
