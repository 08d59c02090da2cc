// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "core/brdf/tabulated_brdf.h"

namespace gonio::factorization {

inline constexpr int defaultDeviations = 90;
/// Factorisations leave out what lies closer to the horizon (rad): measurements are unreliable there.
inline const double largestPolarAngle = radians(89);
/// |Dp| of the two most grazing directions beside each other.
inline const double largestDeviation = 2 * std::sin(largestPolarAngle);

/// Nodes of |Dp| that lie close where reflectances change: quantiles of the energy by |Dp|, logarithmic in the
/// reflectance, over 2,000 even steps (dissertation eq. 4.24, Paper B and C). A third of them is spread evenly:
/// without, a mirror takes nearly all and leaves gaps that no curve bridges. The first is 0, the last the largest
/// deviation, each at least 1e-6 beyond the one before.
/// @param tables one material, or a set that shares the nodes; black ones give even nodes. About 0.1 s a table.
/// @throws Cancelled.
std::vector<double> deviationNodes(std::span<const std::shared_ptr<const TabulatedBrdf>> tables,
                                   int count = defaultDeviations, const TaskControl& control = {});

/// The quantiles themselves. @param energy of even steps up to the largest deviation, >= 0.
std::vector<double> deviationNodes(std::span<const double> energy, int count);

}  // namespace gonio::factorization
