// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/mode_products.h"

namespace gonio::dictionary {

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

}  // namespace gonio::dictionary
