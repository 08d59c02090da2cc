// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>

namespace gonio {

/// Display sRGB, 8 bits per channel.
using DisplayColour = std::array<std::uint8_t, 3>;

/// The viridis colour map (Smith and van der Walt 2015), linear between ten nodes; lightness increases with the value.
/// `x` is clamped to [0, 1].
DisplayColour viridis(double x);

/// For signed quantities: blue below 0, near black at 0, orange above, lighter with the magnitude. `x` is clamped to
/// [-1, 1].
DisplayColour signedColour(double x);

}  // namespace gonio
