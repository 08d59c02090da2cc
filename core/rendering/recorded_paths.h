// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/math/image.h"
#include "core/support/task_control.h"

namespace gonio {

/// The camera paths of a scene, traced once for pictures of many materials. Where no light is reflected twice and every
/// material is sampled with the same lobe, these pictures have the same paths, and each is a weighted sum of the
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

  /// The picture that renderPicture() returns for a material with the lobe of the paths, up to rounding: linear RGB
  /// radiance, bitwise equal for any number of threads. @throws Cancelled.
  Image picture(const Brdf& brdf, const TaskControl& control = {}) const;

 private:
  std::vector<Row> rows_;
  Image others_;
  int samples_;
};

}  // namespace gonio
