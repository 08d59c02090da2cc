// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/support/task_control.h"

namespace gonio::factorization {

/// A reflectance of two angles alone, rho(theta_h, theta_d): the mean over the azimuths phi_d that were measured.
/// Romeiro, Vasilyev and Zickler 2008, "Passive Reflectometry". Exact where rho does not depend on phi_d; what an
/// azimuth has of its own (off-specular shadowing, retro-reflection beside the plane of incidence) is lost.
///
/// Derived here: the side is free (the paper's has 90 nodes) so that tables can be compared at equal bytes; the nodes
/// are those of a MERL table of that side.
struct BivariateTable {
  int side = 0;                   ///< nodes of theta_h and of theta_d
  std::vector<glm::vec3> values;  ///< 1/sr, theta_d fastest
};

/// The largest side whose single-precision RGB table fits, [2, 90].
int bivariateSide(std::size_t byteBudget);

/// @param side at least 2. Nodes without a measured azimuth take the value of the nearest theta_h that has one.
/// About 0.1 s at 90. @throws Cancelled.
BivariateTable averageBivariate(const TabulatedBrdf& table, int side, const TaskControl& control = {});

/// Bilinear in (sqrt theta_h, theta_d).
std::shared_ptr<const Brdf> makeBivariateBrdf(BivariateTable table);

}  // namespace gonio::factorization
