// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace gonio {

EigenBasis eigenBasis(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix);
  // Eigenvalues ascend.
  EigenBasis basis{eigen.eigenvectors().rowwise().reverse(), eigen.eigenvalues().reverse().cwiseMax(0)};
  for (Eigen::Index c = 0; c < basis.vectors.cols(); ++c) {
    Eigen::Index largest = 0;
    basis.vectors.col(c).cwiseAbs().maxCoeff(&largest);
    if (basis.vectors(largest, c) < 0) basis.vectors.col(c) = -basis.vectors.col(c);
  }
  return basis;
}

ThinSvd thinSvd(const Eigen::MatrixXd& matrix) {
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a.ldlt().solve(b); }

}  // namespace gonio
