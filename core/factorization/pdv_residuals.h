// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <vector>

#include "core/factorization/pdv_factors.h"

namespace gonio::factorization {

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
