// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/math/image.h"

namespace gonio {

/// Light from infinitely far, as a latitude-longitude picture of linear RGB radiance. World axes: y up, the camera of
/// the sphere preview looks along -z. Column x of W covers azimuth phi = 2 pi (x + 0.5) / W, row y of H polar angle
/// theta = pi (y + 0.5) / H from +y; direction = (-sin theta sin phi, cos theta, sin theta cos phi)... so that the
/// centre column lies straight ahead of the camera (-z). Immutable.
class EnvironmentMap {
 public:
  /// @throws Error when the picture is empty or has a non-finite or negative value.
  explicit EnvironmentMap(Image radiance, std::string name);

  const std::string& name() const { return name_; }
  const Image& image() const { return image_; }

  /// Radiance from a world direction (unit), bilinear between pixels, wrapped in azimuth.
  Rgb radiance(const Direction& world) const;

  struct Sample {
    Direction direction;  ///< world
    Rgb radiance;
    double pdf;           ///< 1/sr
  };
  /// Draws a direction with a density proportional to luminance x solid angle, piecewise constant by pixel.
  Sample sample(double u1, double u2) const;
  /// Density of sample(), 1/sr.
  double pdf(const Direction& world) const;

  /// World direction of a position on the picture (u, v in [0, 1], v = 0 is the top) and back: the one place of the
  /// mapping; the shader is its twin.
  static Direction directionAt(double u, double v);
  static glm::dvec2 positionOf(const Direction& world);

  /// Cumulative tables for a sampler elsewhere (the preview's shader): `marginal` has height + 1 entries, `conditional`
  /// height rows of width + 1 entries, each from 0 to 1.
  const std::vector<float>& marginalCdf() const { return marginal_; }
  const std::vector<float>& conditionalCdf() const { return conditional_; }

 private:
  Image image_;
  std::string name_;
  std::vector<float> marginal_, conditional_;
};

/// Made by the project itself, 512 x 256: a photo studio with soft boxes, and a clear sky with a sun.
std::shared_ptr<const EnvironmentMap> studioEnvironment();
std::shared_ptr<const EnvironmentMap> skyEnvironment();
/// Constant white radiance of 1: the furnace.
std::shared_ptr<const EnvironmentMap> furnaceEnvironment();
/// By name: "studio", "sky", "furnace".
/// @throws Error that lists the names.
std::shared_ptr<const EnvironmentMap> bundledEnvironment(const std::string& name);

}  // namespace gonio
