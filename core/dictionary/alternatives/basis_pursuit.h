// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/invalid_cells.h"
#include "core/support/task_control.h"

namespace gonio::dictionary {

/// Soft thresholding of the largest coefficients of a signal: the `count` largest, each moved toward 0 by the absolute
/// value of the largest of the others, which is also returned. @param largest the `count` + 1 largest coefficients in
/// any order, or all if there are fewer (then nothing is subtracted); receives the result by decreasing absolute value.
template <typename Scalar>
Scalar softThreshold(std::vector<Coefficient<Scalar>>& largest, std::size_t count);

/// Basis pursuit denoising (Chen, Donoho and Saunders 1998, "Atomic Decomposition by Basis Pursuit") of the valid cells
/// of a signal over an orthonormal dictionary: `code` minimises |valid cells of (signal - U code)|^2 / 2 + lambda
/// |code|_1, with lambda such that at most `count` coefficients are not 0. By accelerated proximal gradient steps (Beck
/// and Teboulle 2009, "A Fast Iterative Shrinkage-Thresholding Algorithm for Linear Inverse Problems"): a step sets the
/// invalid cells to the values of the code, projects, and applies softThreshold().
///
/// Without invalid cells the first step is exact, because the dictionary is orthonormal. Each step takes as long as a
/// round of hard thresholding. Returns lambda. @throws Cancelled.
template <typename Scalar>
Scalar pursueBasis(InvalidCellRefinement<Scalar>& cells, std::size_t count, int steps,
                   std::vector<Coefficient<Scalar>>& code, const TaskControl& control = {});

/// Refits the values of a code to the valid cells by least squares without changing its atoms, because soft
/// thresholding makes coefficients too small. By accelerated gradient steps. @throws Cancelled.
template <typename Scalar>
void refitValues(InvalidCellRefinement<Scalar>& cells, int steps, std::vector<Coefficient<Scalar>>& code,
                 const TaskControl& control = {});

extern template float softThreshold(std::vector<Coefficient<float>>&, std::size_t);
extern template float pursueBasis(InvalidCellRefinement<float>&, std::size_t, int, std::vector<Coefficient<float>>&,
                                  const TaskControl&);
extern template void refitValues(InvalidCellRefinement<float>&, int, std::vector<Coefficient<float>>&,
                                 const TaskControl&);
extern template double softThreshold(std::vector<Coefficient<double>>&, std::size_t);
extern template double pursueBasis(InvalidCellRefinement<double>&, std::size_t, int, std::vector<Coefficient<double>>&,
                                   const TaskControl&);
extern template void refitValues(InvalidCellRefinement<double>&, int, std::vector<Coefficient<double>>&,
                                 const TaskControl&);

}  // namespace gonio::dictionary
