// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/decompositions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "core/math/parallel.h"

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

namespace {

/// Rows that are converted to double at once: they and the sum of their products stay in the near caches.
constexpr Eigen::Index blockRows = 512;
/// The rows are summed in so many parts, each in its order: enough for the cores of most machines.
constexpr std::size_t parts = 32;
constexpr double weakest = 1e-6;  // of the largest singular value
constexpr Eigen::Index tileColumns = 128;

Eigen::MatrixXd projectorOf(const GramSvd& svd) { return svd.v * svd.singularValues.cwiseInverse().asDiagonal(); }

}  // namespace

Eigen::MatrixXd gramMatrix(const TallMatrix& matrix, const TaskControl& control) {
  const auto all = matrix.view();
  const Eigen::Index blocks = (all.rows() + blockRows - 1) / blockRows;
  std::vector<Eigen::MatrixXd> sums(parts);
  parallelForBlocks(
      parts, 1,
      [&](std::size_t part, std::size_t) {
        Eigen::MatrixXd& sum = sums[part];
        sum.setZero(all.cols(), all.cols());
        const Eigen::Index end = blocks * Eigen::Index(part + 1) / Eigen::Index(parts);
        for (Eigen::Index b = blocks * Eigen::Index(part) / Eigen::Index(parts); b < end; ++b) {
          control.throwIfStopped();
          const Eigen::Index first = b * blockRows, count = std::min(blockRows, all.rows() - first);
          const Eigen::MatrixXd block = all.middleRows(first, count).transpose().cast<double>();
          sum.selfadjointView<Eigen::Lower>().rankUpdate(block);
        }
      },
      control);
  for (std::size_t part = 1; part < parts; ++part) sums[0] += sums[part];
  return sums[0].selfadjointView<Eigen::Lower>();
}

void addToGram(Eigen::MatrixXd& gram, const TallMatrix& block, const TaskControl& control) {
  const Eigen::MatrixXd rows = block.view().cast<double>();
  std::vector<std::pair<Eigen::Index, Eigen::Index>> tiles;  // first row and column in the result
  for (Eigen::Index i = 0; i < rows.cols(); i += tileColumns)
    for (Eigen::Index j = 0; j <= i; j += tileColumns) tiles.emplace_back(i, j);
  parallelForBlocks(
      tiles.size(), 1,
      [&](std::size_t tile, std::size_t) {
        const auto [i, j] = tiles[tile];
        const Eigen::Index height = std::min(tileColumns, rows.cols() - i),
                           width = std::min(tileColumns, rows.cols() - j);
        gram.block(i, j, height, width).noalias() += rows.middleCols(i, height).transpose() * rows.middleCols(j, width);
      },
      control);
}

GramSvd decomposeGram(const Eigen::MatrixXd& gram, int maxComponents) {
  const EigenBasis basis = eigenBasis(gram);
  const Eigen::VectorXd sigma = basis.values.cwiseSqrt();
  Eigen::Index count = 0;
  while (count < std::min<Eigen::Index>(maxComponents, sigma.size()) && sigma[count] > weakest * sigma[0]) ++count;
  return {.u = {}, .singularValues = sigma.head(count), .v = basis.vectors.leftCols(count)};
}

Eigen::MatrixXf leftVectors(const GramSvd& svd, const TallMatrix& block, const TaskControl& control) {
  const Eigen::MatrixXd projector = projectorOf(svd);
  Eigen::MatrixXf result(block.rows, projector.cols());
  parallelForBlocks(
      std::size_t(block.rows), std::size_t(blockRows),
      [&](std::size_t begin, std::size_t end) {
        const auto first = Eigen::Index(begin), count = Eigen::Index(end - begin);
        const Eigen::MatrixXd product = block.view().middleRows(first, count).cast<double>() * projector;
        result.middleRows(first, count) = product.cast<float>();
      },
      control);
  return result;
}

GramSvd decomposeGramSvd(TallMatrix matrix, int maxComponents, const TaskControl& control) {
  constexpr double gramFraction = 0.5;
  GramSvd result = decomposeGram(gramMatrix(matrix, control.between(0, gramFraction)), maxComponents);
  const Eigen::Index count = result.singularValues.size();
  const Eigen::MatrixXd projector = projectorOf(result);
  auto all = matrix.view();
  const auto rows = std::size_t(all.rows());
  parallelForBlocks(
      rows, std::size_t(blockRows),
      [&](std::size_t begin, std::size_t end) {
        auto block = all.middleRows(Eigen::Index(begin), Eigen::Index(end - begin));
        const Eigen::MatrixXd product = block.cast<double>() * projector;
        block.leftCols(count) = product.cast<float>();
      },
      control.between(gramFraction, 1));
  matrix.columns = count;
  matrix.values.resize(rows * std::size_t(count));
  // Giving memory back takes a copy for a moment: not worth it for a few columns of gigabytes.
  if (matrix.values.size() < matrix.values.capacity() / 2) matrix.values.shrink_to_fit();
  result.u = std::move(matrix);
  return result;
}

IncrementalQr::IncrementalQr(Eigen::Index rows, Eigen::Index maxColumns)
    : q_(rows, std::min(rows, maxColumns)), r_(Eigen::MatrixXd::Zero(q_.cols(), q_.cols())) {}

bool IncrementalQr::append(const Eigen::Ref<const Eigen::VectorXd>& column) {
  if (size_ == q_.cols()) return false;
  const double norm = column.stableNorm();
  if (!(norm > 0)) return false;
  // Unit length first: neither tiny nor huge columns leave the range.
  Eigen::VectorXd rest = column / norm;
  Eigen::VectorXd along = Eigen::VectorXd::Zero(size_);
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::VectorXd part = q().transpose() * rest;
    rest.noalias() -= q() * part;
    along += part;
  }
  const double left = rest.norm();
  if (left <= collinear) return false;
  q_.col(size_) = rest / left;
  r_.col(size_).head(size_) = along * norm;
  r_(size_, size_) = left * norm;
  ++size_;
  return true;
}

Eigen::VectorXd IncrementalQr::solve(const Eigen::Ref<const Eigen::VectorXd>& b) const {
  return r().triangularView<Eigen::Upper>().solve(b);
}

}  // namespace gonio
