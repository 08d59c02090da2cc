// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/factorization/tensor.h"
#include "core/support/task_control.h"

namespace gonio::factorization {

/// A sum of `rank` rank-one tensors: sum_r weights[r] factors[0].col(r) o factors[1].col(r) o ... (dissertation 3.1.2).
/// Columns have unit length, or are 0 in components that died (weight 0). The largest entry in size of each column but
/// those of the last mode is positive.
struct CanonicalPolyadic {
  Eigen::VectorXd weights;
  std::vector<Eigen::MatrixXd> factors;  ///< one per mode, size(mode) x rank
  double fit = 0;                        ///< 1 - |X - X^| / |X|; 1 for X = 0
  int iterations = 0;
  bool converged = false;
};

struct CanonicalPolyadicOptions {
  int maxIterations = 500;
  double tolerance = 1e-8;  ///< change of the fit between two iterations at which it stops
  unsigned seed = 1;        ///< of columns beyond what the unfoldings' singular vectors give
};

/// CP decomposition by alternating least squares (dissertation, algorithm 1 as repaired: Gram matrices of the
/// normalised factors). The Khatri-Rao product is never formed. Each step solves with the pseudo-inverse where
/// components are collinear, so that a rank beyond the tensor's gives finite factors. Deterministic. Time of an
/// iteration: about 2 N rank multiplications per entry.
/// @throws Cancelled.
CanonicalPolyadic decomposeCanonicalPolyadic(const Tensor& tensor, int rank,
                                             const CanonicalPolyadicOptions& options = {},
                                             const TaskControl& control = {});

/// The tensor that it stands for.
Tensor compose(const CanonicalPolyadic& decomposition);

}  // namespace gonio::factorization
