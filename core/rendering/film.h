// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/math/image.h"

namespace gonio {

/// Rays that were traced: what effects cost, counted.
struct RayCounters {
  std::uint64_t camera = 0;  ///< from the eye
  std::uint64_t shadow = 0;  ///< toward a sampled place on a light
  std::uint64_t bounce = 0;  ///< along a direction drawn from a material

  RayCounters& operator+=(const RayCounters& other) {
    camera += other.camera;
    shadow += other.shadow;
    bounce += other.bounce;
    return *this;
  }
};

/// The sums of a picture that grows by samples.
struct Film {
  int width = 0, height = 0;
  int samples = 0;               ///< of every pixel
  std::vector<Rgb> radiance;     ///< sums, linear RGB
  std::vector<double> coverage;  ///< samples that met an object or a drawn environment
  RayCounters counters;

  Film() = default;
  Film(int filmWidth, int filmHeight)
      : width(filmWidth),
        height(filmHeight),
        radiance(std::size_t(filmWidth) * std::size_t(filmHeight), Rgb(0)),
        coverage(radiance.size(), 0) {}

  /// The mean of the samples: premultiplied by its alpha; black where there are none.
  Image image() const {
    Image picture(width, height);
    picture.alpha.assign(radiance.size(), 0.f);
    for (std::size_t i = 0; i < radiance.size() && samples > 0; ++i) {
      picture.pixels[i] = glm::vec3(radiance[i] / double(samples));
      picture.alpha[i] = float(coverage[i] / samples);
    }
    return picture;
  }
};

}  // namespace gonio
