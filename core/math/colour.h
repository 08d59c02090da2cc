// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

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

/// Limits of the visible range, nm.
inline constexpr double minVisibleWavelength = 380, maxVisibleWavelength = 780;

/// X, Y, Z of the CIE 1931 observer (2 degrees) at a wavelength, nm, within 0.05: the sums of Gaussians of Wyman, Sloan
/// and Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions".
glm::dvec3 colourMatching(double nanometres);

/// Relative power of the CIE standard illuminant D65 at a wavelength, nm: 100 at 560 nm, linear between steps of 10 nm,
/// as ISO 11664-2 defines it. Constant beyond the visible range.
double illuminantD65(double nanometres);

/// Linear sRGB of CIE 1931 tristimulus values, D65 white at Y = 1 (IEC 61966-2-1).
Rgb linearSrgb(const glm::dvec3& xyz);

/// Weights that convert a reflectance or BRDF spectrum to linear sRGB: the sum of value times weight over the
/// wavelengths. The spectrum is linear between them and constant beyond the ends, under D65 for the CIE 1931 observer.
/// A factor per channel scales the white of the approximated observer to (1, 1, 1), so that a constant spectrum gives
/// three equal channels. Weights can be negative: colours outside the sRGB gamut have negative channels.
/// @param nanometres ascending, at least one.
std::vector<Rgb> spectrumWeights(std::span<const double> nanometres);

}  // namespace gonio
