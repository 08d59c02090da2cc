// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

namespace gonio {

/// Decompositions of dense matrices in double precision. Eigen computes them; they are compiled here once, because
/// each costs the compiler many seconds.

/// The eigenvectors of a symmetric positive semi-definite matrix, orthonormal columns, the largest eigenvalue first;
/// the largest entry in size of each column is positive.
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
/// By Jacobi rotations after a QR decomposition with pivots. Cost: O(rows columns min(rows, columns)) and some ten
/// sweeps of O(min(rows, columns)^3).
ThinSvd thinSvd(const Eigen::MatrixXd& matrix);

/// Solves A X = B for a symmetric, positive or negative semi-definite A (LDL^T with pivots), columns of B at once.
/// Cost: O(n^3 + n^2 columns).
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace gonio
