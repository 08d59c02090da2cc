// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

/// Textbook linear algebra to compare with. Compiled once: Eigen's decompositions take a compiler many seconds.
namespace gonio::test {

/// Of a square matrix.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);
/// X with A X = B, of a square matrix.
Eigen::MatrixXd solved(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// The shortest X with the least |A X - B|, by a complete orthogonal decomposition.
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// The whole Q of A = Q R, rows x rows: its first columns span those of A.
Eigen::MatrixXd orthonormalised(const Eigen::MatrixXd& a);

/// A = u diag(values) v^T with thin u and v, values descending, by Jacobi rotations.
struct JacobiSvd {
  Eigen::MatrixXd u;
  Eigen::VectorXd values;
  Eigen::MatrixXd v;
};
JacobiSvd jacobiSvd(const Eigen::MatrixXd& a);
inline Eigen::VectorXd singularValues(const Eigen::MatrixXd& a) { return jacobiSvd(a).values; }

}  // namespace gonio::test
