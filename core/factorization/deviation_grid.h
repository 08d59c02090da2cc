// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "core/brdf/data_transform.h"
#include "core/brdf/tabulated_brdf.h"

namespace gonio::factorization {

inline constexpr int defaultDeviations = 90;
/// Maximum polar angle of factorisations, rad: closer to the horizon, measurements are unreliable.
inline const double maxPolarAngle = radians(89);
/// Maximum |Dp|: that of light and viewer in the same direction at that polar angle (retro-reflection).
inline const double maxDeviation = 2 * std::sin(maxPolarAngle);

/// Nodes of |Dp|, dense where BRDF values are large: quantiles of the energy ln(1 + rho) over 2,000 uniform steps of
/// |Dp| (Tongbuasirilai et al. 2017 and 2019; Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance
/// Modeling and Acquisition", eq. 4.24). A third of the energy is distributed uniformly: otherwise a mirror-like
/// highlight would take nearly all nodes. The first node is 0, the last maxDeviation; adjacent nodes are at least 1e-6
/// apart.
/// @param tables one material, or several that share the nodes; black ones give uniform nodes. About 0.1 s per table.
/// @throws Cancelled.
std::vector<double> deviationNodes(std::span<const std::shared_ptr<const TabulatedBrdf>> tables,
                                   int count = defaultDeviations, const TaskControl& control = {});

/// Energy of a material at 2,000 uniform steps of |Dp|, as summed in Tongbuasirilai 2023, eq. 4.24, over the channels
/// and over the cells on the disk, of a uniform grid of viewers and azimuths. Takes about 0.1 s. @param transform
/// logPlus: ln(1 + rho), the "non-linear energy" of the text; none: rho, as the equation is printed, with which
/// highlights take nearly all nodes. @throws Cancelled.
std::vector<double> publishedDeviationEnergy(const Brdf& brdf, const TaskControl& control = {},
                                             DataTransform transform = DataTransform::logPlus);

/// The published choice, one grid for all materials: the quantiles of the mean of publishedDeviationEnergy() over the
/// 137 measured and near-measured bundled materials, without the uniformly distributed third of the energy
/// (`gonio_studies deviation_nodes` prints them). @param energy logPlus or none, as for publishedDeviationEnergy().
std::vector<double> libraryDeviationNodes(DataTransform energy = DataTransform::logPlus);

/// The quantiles of a given energy. @param energy of uniform steps up to maxDeviation, >= 0.
std::vector<double> deviationNodes(std::span<const double> energy, int count);

}  // namespace gonio::factorization
