// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/fitting/fit_cells.h"

namespace gonio::fitting {

/// Number of strata per half-difference coordinate. phi_h covers the whole circle; phi_d covers half of it, since both
/// orders of the directions are one cell.
struct AzimuthStrata {
  int thetaH, thetaD, phiD, phiH;
};

/// Numbers of strata that the fit uses, and that it excludes as invalid or grazing.
struct AzimuthCellCounts {
  std::size_t used = 0, invalid = 0, grazing = 0;
  std::size_t negative = 0;  ///< channel values of used cells below 0, which count as 0
};

/// Cells for fits to an anisotropic material: one quasi-random pair of directions per stratum (theta_h by its square
/// root, as in tables), weighted by the solid angle d wi d wo of its stratum, computed at the pair. Quasi-random pairs
/// sample narrow ridges along the azimuths in proportion to their solid angle, unlike a regular grid. Since the models
/// are reciprocal, the value is the mean over both orders of the directions if both have data. Deterministic, parallel.
/// @param maxPolarAngle rad; cells with a direction beyond it are grazing. @param counts receives the counts.
FitCells azimuthCells(const Brdf& brdf, double maxPolarAngle, const AzimuthStrata& strata, AzimuthCellCounts& counts);

}  // namespace gonio::fitting
