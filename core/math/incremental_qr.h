// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

namespace gonio {

/// A = Q R of a matrix that grows by columns: Gram-Schmidt, each new column orthogonalised twice, which keeps Q
/// orthonormal to rounding (Giraud et al. 2005, "Rounding error analysis of the classical Gram-Schmidt
/// orthogonalization process"). What greedy choices of columns need: O(rows x columns) a column.
class IncrementalQr {
 public:
  /// A column whose part outside the span of the others is at most this fraction of its length belongs to the span.
  static constexpr double collinear = 1e-8;

  /// Memory for `maxColumns` columns of `rows` entries, at most as many as there are rows.
  IncrementalQr(Eigen::Index rows, Eigen::Index maxColumns);

  Eigen::Index size() const { return size_; }
  /// Orthonormal, rows x size().
  auto q() const { return q_.leftCols(size_); }
  /// Upper triangular, size() x size().
  auto r() const { return r_.topLeftCorner(size_, size_); }

  /// False, and nothing changes, when the column is 0 or lies in the span of those before.
  bool append(const Eigen::Ref<const Eigen::VectorXd>& column);

  /// c of R c = b; with b = Q^T x the coefficients of the columns nearest to x. @param b size() entries.
  Eigen::VectorXd solve(const Eigen::Ref<const Eigen::VectorXd>& b) const;

 private:
  Eigen::MatrixXd q_, r_;
  Eigen::Index size_ = 0;
};

}  // namespace gonio
