// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/dictionary/largest_coefficients.h"
#include "core/dictionary/mode_products.h"

namespace gonio::dictionary {

/// The orthogonal matrix U that maximises trace(U^T Z), square: W V^T of Z = W Sigma V^T (Schoenemann 1966, "A
/// generalized solution of the orthogonal Procrustes problem"). Orthonormal up to rounding for any rank of Z, also for
/// Z = 0.
Eigen::MatrixXd orthogonalProcrustes(const Eigen::MatrixXd& z);

/// Adds X_(mode) (S x_other U)_(mode)^T of one signal X with coefficients S to `z`; the cost is proportional to the
/// number of coefficients. @param projected X x_q U_q^T over the two other modes q, of size `sizes`.
template <typename Scalar>
void addCorrelation(const Scalar* projected, const Sizes& sizes, int mode,
                    std::span<const Coefficient<Scalar>> coefficients, Eigen::MatrixXd& z) {
  const std::array<Eigen::Index, 3> strides{1, sizes[0], Eigen::Index(sizes[0]) * sizes[1]};
  const Eigen::Index stride = strides[std::size_t(mode)];
  using Fibre = Eigen::Map<const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>, 0, Eigen::InnerStride<>>;
  for (const Coefficient<Scalar>& c : coefficients) {
    const Eigen::Index atom = Eigen::Index(c.index) / stride % sizes[std::size_t(mode)];
    const Fibre fibre(projected + (Eigen::Index(c.index) - atom * stride), sizes[std::size_t(mode)],
                      Eigen::InnerStride<>(stride));
    z.col(atom) += double(c.value) * fibre.template cast<double>();
  }
}

}  // namespace gonio::dictionary
