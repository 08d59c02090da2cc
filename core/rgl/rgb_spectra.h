// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/math/types.h"

namespace gonio::rgl {

/// Converts linear sRGB colours to spectra: the sum over the channels of basis times value, after Mallett and Yuksel
/// 2019, "Spectral Primary Decomposition for Rendering with sRGB Reflectance". It is linear, so that interpolated
/// spectra have the interpolated colours, and unbounded like BRDF values (a sigmoid is neither).
struct SpectralBasis {
  std::vector<float> nanometres;  ///< 380 to 720 in steps of 20; linear between them
  std::vector<Rgb> values;        ///< basis values of the three channels per wavelength, >= 0, with sum 1
};

/// The smoothest basis (least squared second differences) with exactly the primaries as colours under D65, for the CIE
/// 1931 observer of core/math/colour.h. Computed once, a few ms.
const SpectralBasis& spectralBasis();

/// The spectrum of a linear sRGB colour at the knots of spectralBasis(), nowhere negative: the sum of the basis for a
/// colour inside sRGB; for one with negative values, a sum that has more saturated spectra too, of one knot each. It is
/// linear within regions of chromaticity and continuous, and has exactly the colour, except for colours that
/// are more saturated than such a spectrum, which become the most similar one.
void colourSpectrum(const Rgb& colour, std::span<float> values);
/// The colour of this spectrum.
Rgb spectralColour(const Rgb& colour);

/// The basis at any wavelength, nm: linear between its knots, constant beyond them.
Rgb spectralBasisAt(double nanometres);

}  // namespace gonio::rgl
