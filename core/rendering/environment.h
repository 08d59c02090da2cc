// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/math/image.h"

namespace gonio {

/// Light from infinitely far, as a latitude-longitude picture of linear RGB radiance. World axes: x right, y up; the
/// camera of the sphere preview looks along -z. A position (u, v) in [0, 1]^2, v = 0 the top, is seen in the direction
///   (sin theta sin a, cos theta, -sin theta cos a),  theta = pi v,  a = 2 pi (u - 1/2):
/// the centre column lies straight ahead of the camera (-z), the azimuth a turns from there toward +x, to the right,
/// and the left and right edges meet behind the camera (+z). Pixel (x, y) has its centre at u = (x + 1/2) / width, v =
/// (y + 1/2) / height. Immutable.
class EnvironmentMap {
 public:
  /// @throws Error when the picture is empty; when a value is not finite or negative: names the first such pixel.
  explicit EnvironmentMap(Image radiance, std::string name);

  const std::string& name() const { return name_; }
  const Image& image() const { return image_; }

  /// Radiance from a world direction (unit), bilinear between pixel centres, wrapped in azimuth.
  Rgb radiance(const Direction& world) const;

  struct Sample {
    Direction direction;  ///< world
    Rgb radiance;
    double pdf;  ///< 1/sr
  };
  /// Samples a direction with a density constant over each pixel's solid angle and proportional to the mean luminance
  /// of the bilinear radiance in it (1/(4 pi) everywhere for a black map). u1 chooses the row, u2 the column.
  Sample sample(double u1, double u2) const;
  /// The same; where the direction is below the horizon of a normal (world), density and radiance are 0.
  Sample sampleAbove(const Direction& normal, double u1, double u2) const;
  /// Density of sample(), 1/sr.
  double pdf(const Direction& world) const;
  /// Radiance and density of one direction: cheaper than asking for both.
  Sample at(const Direction& world) const;

  /// World direction of a position on the picture (u, v in [0, 1], v = 0 is the top) and back: the one place of the
  /// mapping; the shader is its twin.
  static Direction directionAt(double u, double v);
  static glm::dvec2 positionOf(const Direction& world);

 private:
  /// A pixel, and a direction through it.
  struct PixelDirection {
    std::size_t x, y;
    double u, cosTheta, sinTheta;
    Direction direction;
  };
  PixelDirection sampleDirection(double u1, double u2) const;
  Sample at(const PixelDirection& place) const;
  Rgb bilinear(const glm::dvec2& position) const;
  double pixelPdf(std::size_t x, std::size_t y) const;
  void buildTables();

  Image image_;
  std::string name_;
  std::vector<double> cosEdges_;  ///< cos theta of the rows' upper edges, and of the last one's lower edge
  /// Cumulative: height + 1 entries, and height rows of width + 1 entries, each from 0 to 1.
  std::vector<float> marginal_, conditional_;
  std::vector<std::uint32_t> marginalGuide_, conditionalGuide_;  ///< where searches in the tables begin
  std::vector<double> solidAngles_;                              ///< of a pixel in each row, sr
};

/// The turn of an environment about +y: from a world direction to the direction of the environment's picture that is
/// seen there, and back. With c, s the cosine and sine of the angle (rad): (x c + z s, y, z c - x s). Positive angles
/// turn the surroundings from -z toward +x.
class EnvironmentRotation {
 public:
  explicit EnvironmentRotation(double angle);
  Direction toEnvironment(const Direction& w) const { return {w.x * c_ + w.z * s_, w.y, w.z * c_ - w.x * s_}; }
  Direction fromEnvironment(const Direction& w) const { return {w.x * c_ - w.z * s_, w.y, w.z * c_ + w.x * s_}; }

 private:
  double c_, s_;
};

/// The environments that the project makes itself, 512 x 256: "studio" (soft boxes), "sky" (clear, with a sun),
/// "sunset" (a low warm sun in haze), "window" (a dim room with a window and a lamp), "furnace" (radiance 1
/// everywhere).
const std::vector<std::string>& bundledEnvironmentNames();
/// The names with commas between them.
std::string bundledEnvironmentList();
/// Painted when it is first asked for, then shared. @throws Error that lists the names.
std::shared_ptr<const EnvironmentMap> bundledEnvironment(const std::string& name);
std::shared_ptr<const EnvironmentMap> studioEnvironment();
std::shared_ptr<const EnvironmentMap> skyEnvironment();
std::shared_ptr<const EnvironmentMap> furnaceEnvironment();

}  // namespace gonio
