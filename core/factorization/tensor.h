// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace gonio::factorization {

/// An n-mode array of doubles; the first index runs fastest, so that unfoldings are those of Kolda and Bader 2009,
/// "Tensor Decompositions and Applications". Equation numbers refer to Tongbuasirilai 2023, "Data-Driven Approaches for
/// Sparse Reflectance Modeling and Acquisition", section 3.1.
class Tensor {
 public:
  Tensor() = default;
  /// Zeros. @param sizes one per mode, each at least 1, at least one mode.
  explicit Tensor(std::vector<int> sizes);

  int modes() const { return int(sizes_.size()); }
  int size(int mode) const { return sizes_[std::size_t(mode)]; }
  const std::vector<int>& sizes() const { return sizes_; }
  std::size_t count() const { return values_.size(); }

  double* data() { return values_.data(); }
  const double* data() const { return values_.data(); }
  double& operator[](std::size_t i) { return values_[i]; }
  double operator[](std::size_t i) const { return values_[i]; }
  /// Entry of a tensor with three modes.
  double& at(int i, int j, int k) { return values_[offset(i, j, k)]; }
  double at(int i, int j, int k) const { return values_[offset(i, j, k)]; }

  /// Frobenius norm (eq. 3.1).
  double norm() const;

 private:
  std::size_t offset(int i, int j, int k) const {
    return std::size_t(i) + std::size_t(sizes_[0]) * (std::size_t(j) + std::size_t(sizes_[1]) * std::size_t(k));
  }

  std::vector<int> sizes_;
  std::vector<double> values_;
};

/// Sum of the products of all entries (eq. 3.2); the sizes must be equal.
double innerProduct(const Tensor& a, const Tensor& b);

/// The matrix of all fibres of a mode, size(mode) x the rest; the other indices run in their order, the first fastest
/// (eq. 3.4 with q != k).
Eigen::MatrixXd unfold(const Tensor& tensor, int mode);
/// Inverse of unfold().
Tensor fold(const Eigen::MatrixXd& matrix, int mode, const std::vector<int>& sizes);

/// X x_mode U (eq. 3.3): multiplies every fibre of the mode by U, which has size(mode) columns. Stores no unfolding;
/// parallel for large tensors.
Tensor modeProduct(const Tensor& tensor, const Eigen::MatrixXd& matrix, int mode);
/// The same with the transpose of U, which has size(mode) rows.
Tensor transposedModeProduct(const Tensor& tensor, const Eigen::MatrixXd& matrix, int mode);

/// A (x) B (eq. 3.5).
Eigen::MatrixXd kroneckerProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// The Kronecker products of corresponding columns; both must have the same number of columns.
Eigen::MatrixXd khatriRaoProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace gonio::factorization
