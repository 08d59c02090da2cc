// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/math/types.h"

namespace gonio {

/// What an eye sees, nm: spectra are held to the value at their ends beyond these.
inline constexpr double shortestVisible = 380, longestVisible = 780;

/// X, Y, Z of the CIE 1931 observer (2 degrees) at a wavelength, nm, within 0.05: the sums of Gaussians of Wyman, Sloan
/// and Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions".
glm::dvec3 colourMatching(double nanometres);

/// Relative power of the CIE standard illuminant D65 at a wavelength, nm: 100 at 560 nm, linear between steps of 10 nm
/// as ISO 11664-2 defines it. Held at the ends of the visible range.
double daylightPower(double nanometres);

/// Linear sRGB of CIE 1931 tristimulus values, D65 white at Y = 1 (IEC 61966-2-1).
Rgb linearSrgb(const glm::dvec3& xyz);

/// Linear sRGB of a reflectance or a BRDF that is known at some wavelengths is the sum of value times weight: the
/// spectrum is linear between them and constant beyond the ends, lit by D65, seen by the CIE 1931 observer. A factor a
/// channel makes the white of the approximated observer (1, 1, 1), so that an even spectrum gives three equal channels.
/// A weight can be negative: colours outside sRGB have negative channels.
/// @param nanometres ascending, at least one.
std::vector<Rgb> spectrumWeights(std::span<const double> nanometres);

}  // namespace gonio
