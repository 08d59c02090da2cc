// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/mode_products.h"

#include <cassert>

#include "core/math/decompositions.h"

namespace gonio::dictionary {

int rankFor(const Eigen::VectorXd& eigenvalues, double maxLoss) {
  const double most = maxLoss * eigenvalues.sum();
  double left = 0;
  Eigen::Index rank = eigenvalues.size();
  while (rank > 1 && left + eigenvalues[rank - 1] <= most) left += eigenvalues[--rank];
  return int(rank);
}

Eigen::MatrixXd orthogonalProcrustes(const Eigen::MatrixXd& z) {
  assert(z.rows() == z.cols());
  const ThinSvd svd = thinSvd(z);
  return svd.u * svd.v.transpose();
}

}  // namespace gonio::dictionary
