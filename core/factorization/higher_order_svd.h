// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/factorization/tensor.h"

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

}  // namespace gonio::factorization
