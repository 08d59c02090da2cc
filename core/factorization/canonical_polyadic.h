// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/factorization/tensor.h"
#include "core/support/task_control.h"

namespace gonio::factorization {

/// X = core x_1 U_1 x_2 U_2 ... with orthonormal columns in every U. De Lathauwer et al. 2000, "A Multilinear Singular
/// Value Decomposition"; Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition",
/// section 3.1.2.
struct HigherOrderSvd {
  Tensor core;
  std::vector<Eigen::MatrixXd> factors;  ///< one per mode, size(mode) x rank of the mode
};

/// The `count` leading left singular vectors of the unfolding along a mode, size(mode) x count, orthonormal. Computed
/// from the Gram matrix, which is small: modes have hundreds of entries but many fibres. The entry of largest absolute
/// value is positive in each vector.
Eigen::MatrixXd leadingSingularVectors(const Tensor& tensor, int mode, int count);

/// The decomposition truncated to `ranks` (one per mode, at most its size): its squared error is at most the sum of the
/// squared singular values that are left out. Without `ranks` it is exact.
HigherOrderSvd decomposeHigherOrderSvd(const Tensor& tensor, const std::vector<int>& ranks);
inline HigherOrderSvd decomposeHigherOrderSvd(const Tensor& tensor) {
  return decomposeHigherOrderSvd(tensor, tensor.sizes());
}

/// The tensor of a decomposition.
Tensor compose(const HigherOrderSvd& decomposition);

/// A sum of `rank` rank-one tensors: sum_r weights[r] factors[0].col(r) o factors[1].col(r) o ..., where o is the outer
/// product (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", section
/// 3.1.2). Columns have unit length, or are 0 in components of weight 0. The entry of largest absolute value is
/// positive in each column, except in those of the last mode.
struct CanonicalPolyadic {
  Eigen::VectorXd weights;
  std::vector<Eigen::MatrixXd> factors;  ///< one per mode, size(mode) x rank
  double fit = 0;                        ///< 1 - |X - X^| / |X|; 1 for X = 0
  int iterations = 0;
  bool converged = false;
};

struct CanonicalPolyadicOptions {
  int maxIterations = 500;
  double tolerance = 1e-8;  ///< stops when the fit changes by less between two iterations
  unsigned seed = 1;        ///< for initial columns beyond the singular vectors of the unfoldings
};

/// CP decomposition by alternating least squares (Tongbuasirilai 2023, algorithm 1, corrected to use the Gram matrices
/// of the normalised factors). The Khatri-Rao product is not stored. Collinear components are solved with the
/// pseudo-inverse, so that a rank above the tensor's gives finite factors. Deterministic. Cost of an iteration: about 2
/// N rank multiplications per entry, N the number of modes. @throws Cancelled.
CanonicalPolyadic decomposeCanonicalPolyadic(const Tensor& tensor, int rank,
                                             const CanonicalPolyadicOptions& options = {},
                                             const TaskControl& control = {});

/// The tensor of a decomposition.
Tensor compose(const CanonicalPolyadic& decomposition);

}  // namespace gonio::factorization
