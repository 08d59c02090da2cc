// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/factorization/tensor.h"

namespace gonio::factorization {

/// X = core x_1 U_1 x_2 U_2 ... with orthonormal columns in every U. De Lathauwer et al. 2000, "A Multilinear Singular
/// Value Decomposition" (dissertation 3.1.2).
struct HigherOrderSvd {
  Tensor core;
  std::vector<Eigen::MatrixXd> factors;  ///< one per mode, size(mode) x rank of the mode
};

/// The `count` leading left singular vectors of the unfolding along a mode, size(mode) x count, orthonormal. By the
/// eigenvectors of the Gram matrix: sizes are hundreds while fibres are many. The largest entry in size of each is
/// positive.
Eigen::MatrixXd leadingSingularVectors(const Tensor& tensor, int mode, int count);

/// The full decomposition, exact; or the truncated one with `ranks` (one per mode, at most its size), whose squared
/// error is at most the sum of the squared singular values that are left out.
HigherOrderSvd decomposeHigherOrderSvd(const Tensor& tensor, const std::vector<int>& ranks);
inline HigherOrderSvd decomposeHigherOrderSvd(const Tensor& tensor) {
  return decomposeHigherOrderSvd(tensor, tensor.sizes());
}

/// The tensor that it stands for.
Tensor compose(const HigherOrderSvd& decomposition);

}  // namespace gonio::factorization
