// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio {

/// The sRGB transfer function (IEC 61966-2-1) and its inverse, on [0, 1].
double toSrgb(double linear);
double fromSrgb(double encoded);

/// Linear radiance as displayed at exposure 0: each channel clamped to [0, 1], still linear; NaN becomes 0.
Rgb displayed(const Rgb& radiance);

/// CIE 1931 XYZ of linear sRGB (IEC 61966-2-1), each divided by the value of white (1, 1, 1).
[[gnu::always_inline]] inline Rgb whiteRelativeXyz(double red, double green, double blue) {
  return {(0.4124 * red + 0.3576 * green + 0.1805 * blue) / (0.4124 + 0.3576 + 0.1805),
          0.2126 * red + 0.7152 * green + 0.0722 * blue,
          (0.0193 * red + 0.1192 * green + 0.9505 * blue) / (0.0193 + 0.1192 + 0.9505)};
}

}  // namespace gonio
