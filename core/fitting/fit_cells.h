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

}  // namespace gonio::fitting
