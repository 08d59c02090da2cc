// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/dictionary/principal_components.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

struct ConditionSearchResult {
  std::vector<std::size_t> rows;  ///< of the basis' mapping, distinct
  double conditionNumber = 0;     ///< of these rows of U Sigma, infinite where they are dependent
};

/// The search of Nielsen et al. 2015, "On Optimal, Minimal BRDF Sampling for Reflectance Acquisition": `samples` rows
/// of the dictionary U Sigma of as many components (at most all) whose condition number is small. From random rows,
/// each row in turn moves to that of its six neighbours on the grid (one step in theta_h, theta_d or phi_d, which
/// wraps) that lowers the condition number most, until no move of any row lowers it; the best of several starts. One
/// row: that of the largest norm.
///
/// Exact: a move is passed over without an evaluation only where the Rayleigh quotients of the extreme eigenvectors of
/// the rows' Gram matrix prove that it does not help. Those take O(m) a move, an evaluation O(m^3). Starts in parallel.
/// @param rows candidates, ascending, at least one. @throws Cancelled.
ConditionSearchResult searchByCondition(const dictionary::PrincipalComponents& basis,
                                        const std::vector<std::size_t>& rows, int samples, std::uint64_t seed,
                                        int restarts, const TaskControl& control = {});

}  // namespace gonio::acquisition
