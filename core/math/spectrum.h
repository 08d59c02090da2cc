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

/// Linear sRGB of a reflectance that is known at some wavelengths is the sum of value times weight: the spectrum runs
/// straight between them and on level beyond the ends, under an even light whose white is made (1, 1, 1) by a factor a
/// channel. A weight can be negative: colours outside sRGB have negative channels.
/// @param nanometres ascending, at least one.
std::vector<Rgb> spectrumWeights(std::span<const double> nanometres);

}  // namespace gonio
