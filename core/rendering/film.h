// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/math/image.h"
#include "core/support/task_control.h"

namespace gonio::rendering {

/// Numbers of traced rays, as a measure of the cost of effects.
struct RayCounters {
  std::uint64_t camera = 0;  ///< from the camera
  std::uint64_t shadow = 0;  ///< toward a sampled point on a light
  std::uint64_t bounce = 0;  ///< along a direction sampled from a material

  RayCounters& operator+=(const RayCounters& other) {
    camera += other.camera;
    shadow += other.shadow;
    bounce += other.bounce;
    return *this;
  }
};

/// Histogram of the luminances of samples, independent of their order.
class SampleLuminances {
 public:
  void add(double luminance) {
    if (!(luminance > 0)) return;
    largest_ = std::max(largest_, luminance);
    // The bin is given by the exponent and the first three bits of the mantissa.
    constexpr int mantissaBits = 52, binBits = 3, bias = 1022;
    static_assert(binsPerOctave == 1 << binBits);
    const auto place = int(std::bit_cast<std::uint64_t>(luminance) >> (mantissaBits - binBits));
    ++counts_[std::size_t(std::clamp(place - (bias + lowestOctave) * binsPerOctave, 0, binsPerOctave * octaves - 1))];
  }
  SampleLuminances& operator+=(const SampleLuminances& other);

  double largest() const { return largest_; }
  /// Sum of the samples of at least `threshold`, with a relative error of at most 1/16 per sample (each counts as the
  /// middle of its bin).
  double sumFrom(double threshold) const;

 private:
  static constexpr int binsPerOctave = 8, lowestOctave = -64, octaves = 128;
  std::array<std::uint64_t, std::size_t(binsPerOctave* octaves)> counts_{};
  double largest_ = 0;
};

/// Statistics of fireflies: rare samples that are much brighter than the rest, which cause noise that decreases slowly.
/// They are reported, not clamped.
struct Fireflies {
  /// A sample is a firefly if its luminance is at least this multiple of the mean luminance of the samples that hit
  /// something.
  static constexpr double threshold = 100;
  double brightest = 0;  ///< luminance of the brightest sample, relative to the mean of the samples that hit something
  double fraction = 0;   ///< fraction of the image's luminance that comes from samples above `threshold` times the mean
};

/// The part of a camera's picture that a film covers: the position p in [-1, 1]^2 of the film (y up) is at centre +
/// halfSize p of the picture that the camera has without a window.
struct FilmWindow {
  glm::dvec2 centre{0};
  double halfSize = 1;
};

/// Sums of the samples of a picture, to which samples can be added.
struct Film {
  int width = 0, height = 0;
  FilmWindow window;
  int samples = 0;               ///< per pixel
  std::vector<Rgb> radiance;     ///< sums, linear RGB
  std::vector<double> coverage;  ///< number of samples that hit an object or a visible environment
  /// Features for noise filters: sums of the normal at the first hit (0 without a hit) and, in w, of the squared
  /// luminance. Empty unless enableFeatures() was called.
  std::vector<glm::vec4> features;
  RayCounters counters;
  SampleLuminances luminances;

  Film() = default;
  Film(int filmWidth, int filmHeight, const FilmWindow& filmWindow = {})
      : width(filmWidth),
        height(filmHeight),
        window(filmWindow),
        radiance(std::size_t(filmWidth) * std::size_t(filmHeight), Rgb(0)),
        coverage(radiance.size(), 0) {}

  /// Enables `features`, 16 bytes per pixel. Call it before the first sample.
  void enableFeatures() { features.assign(radiance.size(), glm::vec4(0)); }

  /// The mean of the samples, premultiplied by its alpha; black without samples.
  Image image() const {
    Image picture(width, height);
    picture.alpha.assign(radiance.size(), 0.f);
    for (std::size_t i = 0; i < radiance.size() && samples > 0; ++i) {
      picture.pixels[i] = glm::vec3(radiance[i] / double(samples));
      picture.alpha[i] = float(coverage[i] / samples);
    }
    return picture;
  }

  /// All values are 0 for a black picture.
  Fireflies fireflies() const;
};

/// The camera paths of a scene, traced once for pictures of many materials. Where no light is reflected twice and every
/// material is sampled with the same density, these pictures have the same paths, and each is a weighted sum of the
/// material's BRDF values, which needs neither rays nor densities. For GGX it takes about a twelfth of the time of
/// tracing the paths. Immutable.
class RecordedPaths {
 public:
  /// BRDF values that contribute to a row of pixels, in the order in which the path tracer adds them.
  struct Row {
    std::vector<DirectionPair> pairs;   ///< local directions
    std::vector<Rgb> weights;           ///< factor of the value: radiance times cosine over density
    std::vector<std::uint32_t> pixels;  ///< index in the image

    void add(std::size_t pixel, const DirectionPair& pair, const Rgb& weight) {
      pairs.push_back(pair);
      weights.push_back(weight);
      pixels.push_back(std::uint32_t(pixel));
    }
  };

  /// @param rows one per row of pixels. @param others the picture of what does not depend on the material, such as a
  /// visible environment. @param samples per pixel.
  RecordedPaths(std::vector<Row> rows, Image others, int samples);

  /// The picture that renderPicture() returns for a material with the density of the paths, up to rounding: linear RGB
  /// radiance, bitwise equal for any number of threads. @throws Cancelled.
  Image picture(const Brdf& brdf, const TaskControl& control = {}) const;

  /// One per row of pixels; divided by samples() the sums of values times weights are the radiance of the pixels.
  const std::vector<Row>& rows() const { return rows_; }
  int samples() const { return samples_; }

 private:
  std::vector<Row> rows_;
  Image others_;
  int samples_;
};

}  // namespace gonio::rendering
