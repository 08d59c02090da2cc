// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/math/image.h"

namespace gonio {

/// Differences of pictures from one reference on one scale, in the colours of viridis().
struct ErrorMaps {
  /// Straight sRGB RGBA, 4 bytes per pixel; as transparent as the reference. One per picture.
  std::vector<std::vector<std::uint8_t>> maps;
  double range = 0;  ///< the absolute difference of luminance that has the last colour; larger ones have it too
};

/// The scale ends at the 99.5th percentile of all differences, rounded up to 1, 2 or 5 times a power of ten, so that
/// single noisy pixels do not darken the rest; 0 where all pictures are equal.
/// Contract: all pictures have the reference's size.
ErrorMaps errorMaps(const Image& reference, std::span<const Image> pictures);

/// The parts of it, for maps of several references on one scale: where the scale of these pictures ends, and the map of
/// one picture on a scale that ends at `range`, where 0 gives the first colour everywhere. Contract likewise.
double errorRange(const Image& reference, std::span<const Image> pictures);
std::vector<std::uint8_t> errorMap(const Image& reference, const Image& picture, double range);

}  // namespace gonio
