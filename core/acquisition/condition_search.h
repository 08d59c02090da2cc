// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/dictionary/principal_components.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

struct ConditionSearchResult {
  std::vector<std::size_t> rows;  ///< indices into basis.mapping.cells, distinct
  double conditionNumber = 0;     ///< of these rows of U Sigma; infinite if they are dependent
};

/// Finds `samples` rows (all, if there are fewer) of the scaled basis U Sigma that have a small condition number, by
/// the search of Nielsen et al. 2015, "On Optimal, Minimal BRDF Sampling for Reflectance Acquisition". The scaled basis
/// has the first min(number of chosen rows, basis.count()) components. Each search starts at random rows; each row in
/// turn moves to that one of its six neighbours on the grid (one step in theta_h, theta_d or phi_d, which wraps) that
/// lowers the condition number most, until no single move lowers it. Returns the best of `restarts` searches; for one
/// sample the row of largest norm.
///
/// Exact: a move is skipped only if the Rayleigh quotients of the extreme eigenvectors of the rows' Gram matrix prove
/// that it does not help. That test costs O(m) per move, an evaluation O(m^3), m = samples. The searches run in
/// parallel. @param rows candidates in basis.mapping.cells, ascending, at least one. @throws Cancelled.
ConditionSearchResult searchByCondition(const dictionary::PrincipalComponents& basis,
                                        const std::vector<std::size_t>& rows, int samples, std::uint64_t seed,
                                        int restarts, const TaskControl& control = {});

}  // namespace gonio::acquisition
