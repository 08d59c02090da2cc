// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/support/task_control.h"

namespace gonio::baselines {

/// A BRDF of two angles only, rho(theta_h, theta_d): the mean over the measured azimuths phi_d. Romeiro, Vasilyev and
/// Zickler 2008, "Passive Reflectometry". Exact if rho does not depend on phi_d; variation with the azimuth
/// (masking and shadowing, retro-reflection outside the plane of incidence) is lost.
///
/// Differences from the paper: the number of nodes per axis is variable (90 in the paper), so that tables of equal size
/// in bytes can be compared; the nodes are those of a MERL table of that side.
struct BivariateTable {
  int side = 0;                   ///< number of nodes of theta_h and of theta_d
  std::vector<glm::vec3> values;  ///< 1/sr, theta_d fastest
};

/// The largest number of nodes per axis, in [2, 90], for which a single-precision RGB table fits in the budget.
int bivariateSide(std::size_t byteBudget);

/// @param side at least 2. Nodes without a measured azimuth take the value of the nearest theta_h that has one.
/// About 0.1 s for side 90. @throws Cancelled.
BivariateTable averageBivariate(const TabulatedBrdf& table, int side, const TaskControl& control = {});

/// Bilinear in (sqrt theta_h, theta_d).
std::shared_ptr<const Brdf> makeBivariateBrdf(BivariateTable table);

}  // namespace gonio::baselines
