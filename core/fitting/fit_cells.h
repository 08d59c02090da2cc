// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/fitting/fit_parameters.h"

namespace gonio::fitting {

/// The cells of a table that a fit uses.
struct CellSelection {
  std::vector<std::uint8_t> isUsed;  ///< one flag per cell: 1 if used
  std::size_t used = 0, invalid = 0, grazing = 0;
};
/// @param maxPolarAngle rad; cells with a direction beyond it are grazing. Parallel, O(cells).
CellSelection selectCells(const TabulatedBrdf& table, double maxPolarAngle);

/// The cells of a fit as arrays.
struct FitCells {
  std::vector<DirectionPair> pairs;
  std::vector<double> cosI, cosO;             ///< cosines of the polar angles of wi and wo, >= 0
  std::vector<double> rootWeight;             ///< square root of the weight; the weights have sum 1
  std::array<std::vector<double>, 3> values;  ///< BRDF values per channel, 1/sr, without the cosine
  DataSymmetry symmetry = DataSymmetry::isotropic;

  std::size_t size() const { return pairs.size(); }
  /// @param weight of the cell, not normalised. Call normaliseWeights() after the last cell, which sets rootWeight.
  void append(const DirectionPair& pair, const Rgb& value, double weight);
  void normaliseWeights();
};

/// A stratified subset of the used cells: each theta_h row is divided into about `thetaDStrata` x `phiDStrata` patches,
/// and one cell represents its patch with the measure of all its cells. No row is left out, so the highlight remains
/// resolved. Deterministic.
FitCells stratifiedCells(const TabulatedBrdf& table, const CellSelection& selection, int thetaDStrata, int phiDStrata);

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
