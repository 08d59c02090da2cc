// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/procrustes.h"

#include <cassert>

#include "core/math/decompositions.h"

namespace gonio::dictionary {

Eigen::MatrixXd orthogonalProcrustes(const Eigen::MatrixXd& z) {
  assert(z.rows() == z.cols());
  const ThinSvd svd = thinSvd(z);
  return svd.u * svd.v.transpose();
}

}  // namespace gonio::dictionary
