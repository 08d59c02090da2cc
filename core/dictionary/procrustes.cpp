// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/procrustes.h"

#include <Eigen/SVD>
#include <cassert>

namespace gonio::dictionary {

Eigen::MatrixXd orthogonalProcrustes(const Eigen::MatrixXd& z) {
  assert(z.rows() == z.cols());
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(z, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

}  // namespace gonio::dictionary
