// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/support/task_control.h"

namespace gonio::factorization {

/// Y ~ left * right with non-negative factors.
struct NonnegativeFactors {
  Eigen::MatrixXd left, right;    ///< rows x rank, rank x columns
  std::vector<double> residuals;  ///< |Y - left right| (Frobenius norm) at the start and after each iteration; never
                                  ///< increases
};

struct NonnegativeOptions {
  int maxIterations = 500;
  double tolerance = 1e-6;  ///< stops when an iteration lowers the residual by less than this fraction
  unsigned seed = 1;        ///< of the initial values, random in (0.1, 1]: multiplicative updates cannot change a zero
};

/// Non-negative matrix factorisation by the multiplicative updates of Lee and Seung 2001, "Algorithms for Non-negative
/// Matrix Factorization". Negative entries of Y count as 0. Deterministic for a given seed. @throws Cancelled.
NonnegativeFactors factorizeNonnegative(const Eigen::MatrixXd& matrix, int rank, const NonnegativeOptions& options = {},
                                        const TaskControl& control = {});

}  // namespace gonio::factorization
