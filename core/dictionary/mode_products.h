// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

/// Products of three-mode blocks (third-order tensors) with matrices, in the precision of the block; training and
/// encoding spend most of their time here. As in Tensor, the first index of a block runs fastest.
namespace gonio::dictionary {

template <typename Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
using Sizes = std::array<int, 3>;
/// One matrix per mode.
template <typename Scalar>
using ModeMatrices = std::array<Matrix<Scalar>, 3>;

inline std::size_t count(const Sizes& sizes) { return std::size_t(sizes[0]) * sizes[1] * sizes[2]; }

/// target = block x_mode M^T: every fibre of the mode, of length sizes[mode], is mapped to length M.cols(). `target`
/// must not overlap `block`. 2 count(sizes) M.cols() operations by Eigen's matrix product.
template <typename Scalar>
void transposedModeProduct(const Scalar* block, const Sizes& sizes, int mode, const Matrix<Scalar>& m, Scalar* target) {
  assert(m.rows() == sizes[std::size_t(mode)]);
  using Map = Eigen::Map<Matrix<Scalar>>;
  using ConstMap = Eigen::Map<const Matrix<Scalar>>;
  const Eigen::Index n0 = sizes[0], n1 = sizes[1], n2 = sizes[2];
  if (mode == 0) {
    Map(target, m.cols(), n1 * n2).noalias() = m.transpose() * ConstMap(block, n0, n1 * n2);
  } else if (mode == 2) {
    Map(target, n0 * n1, m.cols()).noalias() = ConstMap(block, n0 * n1, n2) * m;
  } else {
    for (Eigen::Index k = 0; k < n2; ++k)
      Map(target + n0 * m.cols() * k, n0, m.cols()).noalias() = ConstMap(block + n0 * n1 * k, n0, n1) * m;
  }
}

/// Storage of a block. Eigen's sums begin at the first address that fits a vector register, so that their rounding
/// depends on the alignment, which would differ from thread to thread.
template <typename Scalar>
using BlockStorage = std::vector<Scalar, Eigen::aligned_allocator<Scalar>>;

/// Two scratch blocks, reused between calls.
template <typename Scalar>
struct Workspace {
  BlockStorage<Scalar> first, second;
};

/// block x_0 M_0^T x_1 M_1^T x_2 M_2^T without the mode `skipped` (-1: none). The result points into the workspace.
/// @param order of the modes; put those first that make the block smaller.
template <typename Scalar>
const Scalar* transposedModeProducts(const Scalar* block, Sizes sizes, const ModeMatrices<Scalar>& matrices,
                                     Workspace<Scalar>& workspace, int skipped = -1,
                                     const std::array<int, 3>& order = {0, 1, 2}) {
  for (const int mode : order) {
    if (mode == skipped) continue;
    Sizes next = sizes;
    next[std::size_t(mode)] = int(matrices[std::size_t(mode)].cols());
    BlockStorage<Scalar>& target = block == workspace.first.data() ? workspace.second : workspace.first;
    target.resize(count(next));
    transposedModeProduct(block, sizes, mode, matrices[std::size_t(mode)], target.data());
    block = target.data();
    sizes = next;
  }
  return block;
}

/// Adds X_(mode) X_(mode)^T of a block to `gram`. Computes the matrix product in the block's precision.
template <typename Scalar>
void addGram(const Scalar* block, const Sizes& sizes, int mode, Eigen::MatrixXd& gram) {
  using Map = Eigen::Map<const Matrix<Scalar>>;
  const Eigen::Index n0 = sizes[0], n1 = sizes[1], n2 = sizes[2];
  if (mode == 0) {
    const Map fibres(block, n0, n1 * n2);
    gram += (fibres * fibres.transpose()).template cast<double>();
  } else if (mode == 2) {
    const Map fibres(block, n0 * n1, n2);
    gram += (fibres.transpose() * fibres).template cast<double>();
  } else {
    for (Eigen::Index k = 0; k < n2; ++k) {
      const Map slab(block + n0 * n1 * k, n0, n1);
      gram += (slab.transpose() * slab).template cast<double>();
    }
  }
}

/// The smallest number of leading eigenvectors, at least 1, that loses at most the fraction `maxLoss` of the energy.
/// @param eigenvalues of a Gram matrix, descending.
int rankFor(const Eigen::VectorXd& eigenvalues, double maxLoss);

/// The orthogonal matrix U that maximises trace(U^T Z), square: W V^T of Z = W Sigma V^T (Schoenemann 1966, "A
/// generalized solution of the orthogonal Procrustes problem"). Orthonormal up to rounding for any rank of Z, also for
/// Z = 0.
Eigen::MatrixXd orthogonalProcrustes(const Eigen::MatrixXd& z);

}  // namespace gonio::dictionary
