// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/tensor.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

std::size_t product(const std::vector<int>& sizes, std::size_t begin, std::size_t end) {
  std::size_t result = 1;
  for (std::size_t i = begin; i < end; ++i) result *= std::size_t(sizes[i]);
  return result;
}

/// A tensor as slabs of matrices: before x size(mode), one for each index behind the mode.
struct Slabs {
  std::size_t before, along, behind;
  Slabs(const std::vector<int>& sizes, int mode)
      : before(product(sizes, 0, std::size_t(mode))),
        along(std::size_t(sizes[std::size_t(mode)])),
        behind(product(sizes, std::size_t(mode) + 1, sizes.size())) {}
};

using SlabMatrix = Eigen::Map<Eigen::MatrixXd>;
using ConstSlabMatrix = Eigen::Map<const Eigen::MatrixXd>;

/// Every slab times `right`, which is size(mode) x the new size.
template <typename Right>
Tensor slabProduct(const Tensor& tensor, const Right& right, int mode) {
  assert(right.rows() == tensor.size(mode));
  const Slabs slabs(tensor.sizes(), mode);
  std::vector<int> sizes = tensor.sizes();
  sizes[std::size_t(mode)] = int(right.cols());
  Tensor result(sizes);
  const auto before = Eigen::Index(slabs.before), along = Eigen::Index(slabs.along), count = right.cols();
  if (mode == 0) {  // all fibres are columns of one matrix
    constexpr std::size_t block = 512;
    parallelForBlocks(slabs.behind, block, [&](std::size_t begin, std::size_t end) {
      const auto columns = Eigen::Index(end - begin);
      SlabMatrix(result.data() + begin * std::size_t(count), count, columns).noalias() =
          right.transpose() * ConstSlabMatrix(tensor.data() + begin * slabs.along, along, columns);
    });
    return result;
  }
  constexpr std::size_t rows = 512;
  const std::size_t parts = (slabs.before + rows - 1) / rows;
  parallelForBlocks(slabs.behind * parts, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; ++at) {
      const std::size_t slab = at / parts, first = at % parts * rows;
      const auto height = Eigen::Index(std::min(rows, slabs.before - first)), row = Eigen::Index(first);
      const ConstSlabMatrix from(tensor.data() + slab * slabs.before * slabs.along, before, along);
      SlabMatrix to(result.data() + slab * slabs.before * std::size_t(count), before, count);
      to.middleRows(row, height).noalias() = from.middleRows(row, height) * right;
    }
  });
  return result;
}

}  // namespace

Tensor::Tensor(std::vector<int> sizes) : sizes_(std::move(sizes)), values_(product(sizes_, 0, sizes_.size()), 0.0) {
  assert(!sizes_.empty());
}

double Tensor::norm() const { return std::sqrt(innerProduct(*this, *this)); }

double innerProduct(const Tensor& a, const Tensor& b) {
  assert(a.sizes() == b.sizes());
  constexpr std::size_t block = 1 << 14;
  return parallelSumBlocks(a.count(), block, [&](std::size_t begin, std::size_t end) {
    return std::inner_product(a.data() + begin, a.data() + end, b.data() + begin, 0.0);
  });
}

Eigen::MatrixXd unfold(const Tensor& tensor, int mode) {
  const Slabs slabs(tensor.sizes(), mode);
  const auto before = Eigen::Index(slabs.before), along = Eigen::Index(slabs.along);
  Eigen::MatrixXd result(along, before * Eigen::Index(slabs.behind));
  for (std::size_t slab = 0; slab < slabs.behind; ++slab)
    result.middleCols(Eigen::Index(slab) * before, before) =
        ConstSlabMatrix(tensor.data() + slab * slabs.before * slabs.along, before, along).transpose();
  return result;
}

Tensor fold(const Eigen::MatrixXd& matrix, int mode, const std::vector<int>& sizes) {
  Tensor result(sizes);
  const Slabs slabs(sizes, mode);
  const auto before = Eigen::Index(slabs.before), along = Eigen::Index(slabs.along);
  assert(matrix.rows() == along && matrix.size() == Eigen::Index(result.count()));
  for (std::size_t slab = 0; slab < slabs.behind; ++slab)
    SlabMatrix(result.data() + slab * slabs.before * slabs.along, before, along) =
        matrix.middleCols(Eigen::Index(slab) * before, before).transpose();
  return result;
}

Tensor modeProduct(const Tensor& tensor, const Eigen::MatrixXd& matrix, int mode) {
  return slabProduct(tensor, matrix.transpose(), mode);
}

Tensor transposedModeProduct(const Tensor& tensor, const Eigen::MatrixXd& matrix, int mode) {
  return slabProduct(tensor, matrix, mode);
}

Eigen::MatrixXd kroneckerProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd result(a.rows() * b.rows(), a.cols() * b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      result.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
  return result;
}

Eigen::MatrixXd khatriRaoProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  assert(a.cols() == b.cols());
  Eigen::MatrixXd result(a.rows() * b.rows(), a.cols());
  for (Eigen::Index r = 0; r < a.cols(); ++r)
    for (Eigen::Index i = 0; i < a.rows(); ++i) result.col(r).segment(i * b.rows(), b.rows()) = a(i, r) * b.col(r);
  return result;
}

}  // namespace gonio::factorization
