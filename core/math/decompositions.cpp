// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>

namespace gonio {

EigenBasis eigenBasis(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix);
  // Eigenvalues ascend.
  EigenBasis basis{eigen.eigenvectors().rowwise().reverse(), eigen.eigenvalues().reverse().cwiseMax(0)};
  for (auto vector : basis.vectors.colwise()) {
    const double significant = vector.cwiseAbs().maxCoeff() / 2;
    Eigen::Index first = 0;
    while (std::abs(vector[first]) < significant) ++first;
    if (vector[first] < 0) vector = -vector;
  }
  return basis;
}

ThinSvd thinSvd(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() < matrix.cols()) {
    ThinSvd svd = thinSvd(matrix.transpose());
    svd.u.swap(svd.v);
    return svd;
  }
  const Eigen::Index columns = matrix.cols();
  // With pivots small singular values keep their digits where columns differ in size.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(columns).triangularView<Eigen::Upper>().transpose();
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(triangle,
                                                                         Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(matrix.rows(), columns);
  u.topRows(columns) = svd.matrixV();
  return {qr.householderQ() * u, svd.singularValues(), qr.colsPermutation() * svd.matrixU()};
}

Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a.ldlt().solve(b); }

}  // namespace gonio
