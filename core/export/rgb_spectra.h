// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/math/types.h"

namespace gonio::exports {

/// Converts linear sRGB colours to spectra: the sum over the channels of basis times value, after Mallett and Yuksel
/// 2019, "Spectral Primary Decomposition for Rendering with sRGB Reflectance". It is linear, so that interpolated
/// spectra have the interpolated colours, and unbounded like BRDF values (a sigmoid is neither).
struct SpectralBasis {
  std::vector<float> nanometres;  ///< 380 to 720 in steps of 20; linear between them
  std::vector<Rgb> values;        ///< basis values of the three channels per wavelength, >= 0, with sum 1
};

/// The smoothest basis (least squared second differences) with exactly the primaries as colours under D65, for the CIE
/// 1931 observer of core/math/spectrum.h. Computed once, a few ms.
const SpectralBasis& spectralBasis();

/// The basis at any wavelength, nm: linear between its knots, constant beyond them.
Rgb spectralBasisAt(double nanometres);

}  // namespace gonio::exports
