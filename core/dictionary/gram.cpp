// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/gram.h"

namespace gonio::dictionary {

int rankFor(const Eigen::VectorXd& eigenvalues, double maxLoss) {
  const double most = maxLoss * eigenvalues.sum();
  double left = 0;
  Eigen::Index rank = eigenvalues.size();
  while (rank > 1 && left + eigenvalues[rank - 1] <= most) left += eigenvalues[--rank];
  return int(rank);
}

}  // namespace gonio::dictionary
