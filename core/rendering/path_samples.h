// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/sampling.h"

namespace gonio {

/// Identifies the sample points of a path: its pixel and the index of its sample.
struct PathSeed {
  std::uint32_t pixel, sample;
};

/// Sample points for one purpose (Dimension) at one reflection: an independent two-dimensional set per pixel. The
/// set-up is cached for consecutive paths of a pixel.
class PathSamples {
 public:
  enum Dimension : std::uint32_t { filmPosition, reflectedDirection, reflectedLobe, survival, firstLight };

  /// @param reflection 0 at the camera.
  PathSamples(int reflection, std::uint32_t dimension)
      : dimension_(std::uint32_t(reflection) * dimensionsPerBounce + dimension), pixel_(0), points_(seedOf(0)) {}

  glm::dvec2 pair(const PathSeed& path) { return pointsOf(path.pixel)[path.sample]; }
  double number(const PathSeed& path) { return pointsOf(path.pixel).first(path.sample); }

 private:
  static constexpr std::uint32_t dimensionsPerBounce = 1024;

  std::uint32_t seedOf(std::uint32_t pixel) const { return hashCombine(pixel, dimension_); }
  const SobolPoints& pointsOf(std::uint32_t pixel) {
    if (pixel != pixel_) points_ = SobolPoints(seedOf(pixel_ = pixel));
    return points_;
  }

  std::uint32_t dimension_, pixel_;
  SobolPoints points_;
};

}  // namespace gonio
