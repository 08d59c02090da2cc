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

int GramBasis::rankFor(double mostLoss) const {
  const double most = mostLoss * values.sum();
  double left = 0;
  Eigen::Index rank = values.size();
  while (rank > 1 && left + values[rank - 1] <= most) left += values[--rank];
  return int(rank);
}

}  // namespace gonio::dictionary
