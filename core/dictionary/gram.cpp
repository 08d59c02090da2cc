// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/gram.h"

#include <Eigen/Eigenvalues>

namespace gonio::dictionary {

GramBasis gramBasis(const Eigen::MatrixXd& gram) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  GramBasis basis{eigen.eigenvectors().rowwise().reverse(), eigen.eigenvalues().reverse().cwiseMax(0)};
  for (Eigen::Index c = 0; c < basis.vectors.cols(); ++c) {
    Eigen::Index largest = 0;
    basis.vectors.col(c).cwiseAbs().maxCoeff(&largest);
    if (basis.vectors(largest, c) < 0) basis.vectors.col(c) = -basis.vectors.col(c);
  }
  return basis;
}

}  // namespace gonio::dictionary
