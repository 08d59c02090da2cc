// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/support/task_control.h"

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

/// A column-major matrix in single precision with many rows and few columns. Move it, since it may have gigabytes.
struct TallMatrix {
  std::vector<float> values;
  Eigen::Index rows = 0, columns = 0;

  Eigen::Map<const Eigen::MatrixXf> view() const { return {values.data(), rows, columns}; }
  Eigen::Map<Eigen::MatrixXf> view() { return {values.data(), rows, columns}; }
};

/// T = U Sigma V^T of a tall matrix, without components that cannot be distinguished from rounding errors.
struct GramSvd {
  TallMatrix u;                    ///< orthonormal columns, in single precision
  Eigen::VectorXd singularValues;  ///< descending, > 0
  Eigen::MatrixXd v;               ///< columns of T x components, orthonormal; with the signs of EigenBasis
};

/// T^T T in double, accumulated over blocks of rows; deterministic for any number of threads. rows x columns^2
/// multiplications by Eigen's symmetric product, in parallel. @throws Cancelled.
Eigen::MatrixXd gramMatrix(const TallMatrix& matrix, const TaskControl& control = {});

/// Adds the products of a block of rows to the lower triangle of `gram` = T^T T, a square matrix with as many columns
/// as the block. Parallel over tiles of the result, so that one matrix suffices however many columns there are;
/// deterministic. Memory: 8 bytes per value of the block. @throws Cancelled.
void addToGram(Eigen::MatrixXd& gram, const TallMatrix& block, const TaskControl& control = {});

/// Singular values and V from the lower triangle of T^T T; `u` remains empty. Components are dropped as in
/// decomposeGramSvd(), at most `maxComponents` remain.
GramSvd decomposeGram(const Eigen::MatrixXd& gram, int maxComponents);
/// The rows of U that belong to a block of rows of T: T V / Sigma. Parallel over blocks of rows.
Eigen::MatrixXf leftVectors(const GramSvd& svd, const TallMatrix& block, const TaskControl& control = {});

/// The thin singular value decomposition by the eigenvectors of the Gram matrix (Sirovich 1987, the method of
/// snapshots). The Gram matrix squares the condition number, so components with sigma <= 1e-6 of the largest are
/// dropped, and U is orthonormal to 1e-16 (sigma_1 / sigma)^2 and single precision. U reuses the memory of T.
/// @param maxComponents maximum number of components; the strongest remain. @throws Cancelled.
GramSvd decomposeGramSvd(TallMatrix matrix, int maxComponents, const TaskControl& control = {});

/// QR decomposition of a matrix that grows by columns, for greedy selections: Gram-Schmidt, where each new column is
/// orthogonalised twice, so that Q is orthonormal up to rounding (Giraud et al. 2005, "Rounding error analysis of the
/// classical Gram-Schmidt orthogonalization process"). O(rows x columns) per column.
class IncrementalQr {
 public:
  /// A column belongs to the span of the others if its part outside is at most this fraction of its length.
  static constexpr double collinear = 1e-8;

  /// Allocates memory for `maxColumns` columns of `rows` entries, at most `rows` columns.
  IncrementalQr(Eigen::Index rows, Eigen::Index maxColumns);

  Eigen::Index size() const { return size_; }
  /// Orthonormal, rows x size().
  auto q() const { return q_.leftCols(size_); }
  /// Upper triangular, size() x size().
  auto r() const { return r_.topLeftCorner(size_, size_); }

  /// Appends a column. Returns false, without change, if it is 0 or lies in the span of the previous columns.
  bool append(const Eigen::Ref<const Eigen::VectorXd>& column);

  /// Solves R c = b. For b = Q^T x, c are the least-squares coefficients of x over the columns. @param b size()
  /// entries.
  Eigen::VectorXd solve(const Eigen::Ref<const Eigen::VectorXd>& b) const;

 private:
  Eigen::MatrixXd q_, r_;
  Eigen::Index size_ = 0;
};

}  // namespace gonio
