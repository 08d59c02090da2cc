// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/image.h"

namespace gonio::rendering {

/// Display sRGB, 8 bits per channel.
using DisplayColour = std::array<std::uint8_t, 3>;

/// The viridis colour map (Smith and van der Walt 2015), linear between ten nodes; lightness increases with the value.
/// `x` is clamped to [0, 1].
DisplayColour viridis(double x);

/// For signed quantities: blue below 0, near black at 0, orange above, lighter with the magnitude. `x` is clamped to
/// [-1, 1].
DisplayColour signedColour(double x);

// False-colour maps (viridis()) of the differences of pictures from references, on a common scale.

/// The end of the scale: absolute luminance difference of the last colour; larger ones are clamped. The 99.5th
/// percentile of all differences, rounded up to 1, 2 or 5 times a power of ten, so that single noisy pixels do not
/// dominate; 0 if all pictures are equal. Precondition: all pictures have the reference's size.
double errorRange(const Image& reference, std::span<const Image> pictures);
/// The map of one picture: sRGB RGBA with straight alpha, 4 bytes per pixel, and the alpha of the reference. @param
/// range end of the scale; 0 gives the first colour everywhere. Precondition as above.
std::vector<std::uint8_t> errorMap(const Image& reference, const Image& picture, double range);

}  // namespace gonio::rendering
