// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <vector>

#include "core/dictionary/principal_components.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

struct AOptimalSelection {
  std::vector<std::size_t> rows;  ///< indices into basis.mapping.cells, in the order of choice
  /// Before the first choice and after each: the square root of the expected variance, summed over all cells, relative
  /// to its value before the first choice (so the first entry is 1).
  std::vector<double> residuals;
};

/// Greedy A-optimal Bayesian design (Chaloner and Verdinelli 1995, "Bayesian Experimental Design: A Review"): each
/// step chooses the cell that, once measured, leaves the smallest sum over all cells of the posterior variances of
/// mapped values. Assumes that the coefficients of the components are independent and have the variances of the
/// training set. A sample has a noise of variance 0.03 (a factor of 1.2 in the BRDF value), plus the variance that the
/// components leave out at its cell.
///
/// Of more than 2^18 cells, evenly spaced ones are candidates. O(candidates components^2) per sample, 0.05 s for 30
/// components; 4 bytes x candidates x components of memory. Among equally good candidates the first is chosen; the same
/// rows for any number of threads.
/// @param rows indices into basis.mapping.cells of the cells that can be measured, ascending. @param components at most
/// basis.count(). @param chosen called on this thread with each row. @return fewer rows than `samples` if no candidate
/// reduces the variance. @throws Cancelled.
AOptimalSelection chooseAOptimal(const dictionary::PrincipalComponents& basis, const std::vector<std::size_t>& rows,
                                 int samples, int components, const TaskControl& control = {},
                                 const std::function<void(std::size_t row)>& chosen = {});

}  // namespace gonio::acquisition
