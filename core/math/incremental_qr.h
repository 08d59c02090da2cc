// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

namespace gonio {

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
