// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/fitting/fit_parameters.h"

namespace gonio::fitting {

/// Which cells of a table count for a fit.
struct CellCensus {
  std::vector<std::uint8_t> counts;  ///< one flag a cell
  std::size_t used = 0, invalid = 0, grazing = 0;
};
/// @param maxPolarAngle rad; a cell with a direction beyond it is grazing. In parallel, about 20 ms.
CellCensus takeCensus(const TabulatedBrdf& table, double maxPolarAngle);

/// The cells that a fit compares, in arrays.
struct FitCells {
  std::vector<DirectionPair> pairs;
  std::vector<double> cosI, cosO;             ///< cosines of the polar angles of wi and wo, >= 0
  std::vector<double> rootWeight;             ///< sqrt of the weight; the weights add up to 1
  std::array<std::vector<double>, 3> values;  ///< reflectance by channel, 1/sr
  DataSymmetry symmetry = DataSymmetry::isotropic;

  std::size_t size() const { return pairs.size(); }
  /// @param weight a cell's fraction of what is compared, of any scale: rootWeight is set by normaliseWeights().
  void append(const DirectionPair& pair, const Rgb& value, double weight);
  void normaliseWeights();
};

/// A stratified part of the cells that count: each theta_h row is cut into about `thetaDStrata` x `phiDStrata` patches,
/// one cell of a patch stands for all of it with their whole measure. Every row is kept, so the highlight stays
/// resolved. Deterministic.
FitCells stratifiedCells(const TabulatedBrdf& table, const CellCensus& census, int thetaDStrata, int phiDStrata);

}  // namespace gonio::fitting
