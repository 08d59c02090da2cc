// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/factorization/masked_rank_one.h"
#include "core/factorization/pdv_factors.h"

namespace gonio::factorization {

/// The input of a PDV factorisation: transformed values and weights.
struct PdvSamples {
  std::array<MaskedTensor, 3> channels;  ///< red, green, blue; modes theta_R, |Dp|, |phi|; the same cells have data in
                                         ///< each
  std::size_t cells = 0;                 ///< number of cells on the disk with data
};

/// Samples a table at the nodes of a PDV model: transformed values, as the mean of phi and -phi; in the two-factor form
/// as weighted means over phi.
///
/// Between the last node on the disk and the first outside it, an interpolated model depends on a cell without data.
/// Products of later terms would grow without bound there, so cells next to those with data receive the mean of these
/// neighbours, with a hundredth of their weight. @param axes form, transform and nodes; the curves are ignored.
/// Parallel, deterministic. @throws Cancelled.
PdvSamples samplePdv(const TabulatedBrdf& table, const PdvFactors& axes, PdvWeights weights,
                     const TaskControl& control = {});

/// Relative residual at each node of each axis (theta_R, |Dp|, |phi|).
using PdvResidualsAlong = std::array<std::vector<double>, 3>;

/// One entry for each number of terms 1, 2, ...: per axis and node, |y - y^| / |y| over the cells at this node and all
/// channels, with the norm and the samples of factorizePdv(); 0 where y is 0. The mean of the squares over the nodes of
/// any axis, weighted by |y|^2, is the square of PdvFactorization::residuals. About 0.3 s for a MERL table.
/// @throws Cancelled.
std::vector<PdvResidualsAlong> residualsAlong(const TabulatedBrdf& table, const PdvFactors& factors,
                                              PdvWeights weights = PdvWeights::projectedSolidAngle,
                                              const TaskControl& control = {});

}  // namespace gonio::factorization
