// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/fitting/fit_cells.h"

namespace gonio::fitting {

/// Into how many strata each half-difference coordinate is cut; phi_h, which isotropic materials do not depend on, over
/// the whole circle, phi_d over half of it: both orders of the directions are one cell.
struct AzimuthStrata {
  int thetaH, thetaD, phiD, phiH;
};

/// What became of the strata.
struct AzimuthCensus {
  std::size_t used = 0, invalid = 0, grazing = 0;
  std::size_t negative = 0;  ///< channels of used cells below 0, which count as 0
};

/// The cells of an anisotropic material: a pair of directions somewhere in each stratum (theta_h by its square root, as
/// in tables), with the measure d wi d wo of the stratum there. The places are scattered, so that a narrow ridge across
/// the azimuths is met in its fraction of the cells. The value is the mean over both orders of the directions, where
/// both are measured: the models are reciprocal. Deterministic, in parallel.
/// @param maxPolarAngle rad; a cell with a direction beyond it is grazing.
FitCells azimuthCells(const Brdf& brdf, double maxPolarAngle, const AzimuthStrata& strata, AzimuthCensus& census);

}  // namespace gonio::fitting
