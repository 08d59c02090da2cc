// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "core/math/image.h"

namespace gonio {

/// Rays that were traced: what effects cost, counted.
struct RayCounters {
  std::uint64_t camera = 0;  ///< from the eye
  std::uint64_t shadow = 0;  ///< toward a sampled place on a light
  std::uint64_t bounce = 0;  ///< along a direction sampled from a material

  RayCounters& operator+=(const RayCounters& other) {
    camera += other.camera;
    shadow += other.shadow;
    bounce += other.bounce;
    return *this;
  }
};

/// How bright single samples were, counted in classes of luminance: the same for any order of the samples.
class SampleLuminances {
 public:
  void add(double luminance) {
    if (!(luminance > 0)) return;
    largest_ = std::max(largest_, luminance);
    // The exponent and the first three bits of the mantissa are the number of the class.
    constexpr int mantissaBits = 52, classBits = 3, bias = 1022;
    static_assert(classesOfOctave == 1 << classBits);
    const auto place = int(std::bit_cast<std::uint64_t>(luminance) >> (mantissaBits - classBits));
    ++counts_[std::size_t(
        std::clamp(place - (bias + lowestOctave) * classesOfOctave, 0, classesOfOctave * octaves - 1))];
  }
  SampleLuminances& operator+=(const SampleLuminances& other);

  double largest() const { return largest_; }
  /// Sum of the samples from `threshold` on, each to within a 16th (it counts as the middle of its class).
  double sumFrom(double threshold) const;

 private:
  static constexpr int classesOfOctave = 8, lowestOctave = -64, octaves = 128;
  std::array<std::uint64_t, std::size_t(classesOfOctave* octaves)> counts_{};
  double largest_ = 0;
};

/// Rare samples that are far brighter than the rest: noise that more samples remove slowly. It is reported, not
/// clamped.
struct Fireflies {
  static constexpr double threshold = 100;
  double brightest = 0;  ///< luminance of the brightest sample over the mean of the samples that met something
  double fraction = 0;   ///< of the picture's luminance that comes from samples of more than `threshold` means
};

/// The sums of a picture that grows by samples.
struct Film {
  int width = 0, height = 0;
  int samples = 0;               ///< of every pixel
  std::vector<Rgb> radiance;     ///< sums, linear RGB
  std::vector<double> coverage;  ///< samples that met an object or a drawn environment
  /// What noise filters are guided by: sums of the normal that is first met (0 beside all objects) and, in w, of the
  /// squared luminance. Empty unless keepFeatures() asks for it.
  std::vector<glm::vec4> features;
  RayCounters counters;
  SampleLuminances luminances;

  Film() = default;
  Film(int filmWidth, int filmHeight)
      : width(filmWidth),
        height(filmHeight),
        radiance(std::size_t(filmWidth) * std::size_t(filmHeight), Rgb(0)),
        coverage(radiance.size(), 0) {}

  /// Before the first sample: 16 bytes more per pixel.
  void keepFeatures() { features.assign(radiance.size(), glm::vec4(0)); }

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

  /// All 0 for a black picture.
  Fireflies fireflies() const;
};

}  // namespace gonio
