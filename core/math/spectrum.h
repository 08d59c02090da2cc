// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/math/types.h"

namespace gonio {

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
