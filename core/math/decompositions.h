// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

namespace gonio {

/// Decompositions of dense matrices in double precision by Eigen. Compiled once here, because each takes the compiler
/// many seconds.

/// Eigenvectors of a symmetric positive semi-definite matrix: orthonormal columns, by decreasing eigenvalue. Sign: in
/// each column, the first entry whose absolute value is at least half of the column's largest is positive, so that
/// rounding does not decide the sign.
struct EigenBasis {
  Eigen::MatrixXd vectors;
  Eigen::VectorXd values;  ///< >= 0, descending
};
/// Cost: O(n^3). Reads the lower triangle.
EigenBasis eigenBasis(const Eigen::MatrixXd& matrix);

/// A = U diag(singularValues) V^T with orthonormal columns of U (rows x k) and V (columns x k), k = min(rows, columns).
struct ThinSvd {
  Eigen::MatrixXd u;
  Eigen::VectorXd singularValues;  ///< >= 0, descending
  Eigen::MatrixXd v;
};
/// Jacobi rotations after a QR decomposition with pivoting. Cost: O(rows columns min(rows, columns)) and about ten
/// sweeps of O(min(rows, columns)^3).
ThinSvd thinSvd(const Eigen::MatrixXd& matrix);

/// Solves A X = B for a symmetric, positive or negative semi-definite A (LDL^T with pivoting), for all columns of B.
/// Cost: O(n^3 + n^2 columns).
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace gonio
