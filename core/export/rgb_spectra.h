// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/math/types.h"

namespace gonio::exports {

/// Spectra of linear sRGB colours: the sum over the channels of basis times value. Linear, so that interpolating the
/// spectra is interpolating the colours, and unbounded, as BRDF values are (a sigmoid, which stops at 1, is neither).
/// The idea is that of Mallett and Yuksel 2019, "Spectral Primary Decomposition for Rendering with sRGB Reflectance".
struct SpectralBasis {
  std::vector<float> nanometres;  ///< 380 to 720 in steps of 20; spectra are linear between them
  std::vector<Rgb> values;        ///< of the three channels at each; >= 0, the three add up to 1
};

/// The smoothest basis (least squared second differences) of which D65 and the CIE 1931 observer of
/// core/math/spectrum.h see exactly the primaries. Computed once, some ms.
const SpectralBasis& spectralBasis();

/// The basis at any wavelength, nm: linear between its knots, constant beyond them.
Rgb spectralBasisAt(double nanometres);

}  // namespace gonio::exports
