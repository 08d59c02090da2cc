// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/pursuit_space.h"

#include <cmath>

namespace gonio::acquisition {

PursuitSpace::PursuitSpace(const Eigen::MatrixXd& allSignals)
    : complement(Eigen::MatrixXd::Identity(allSignals.rows(), allSignals.rows())), signals(allSignals) {}

void PursuitSpace::remove(const Eigen::VectorXd& left) {
  const Eigen::VectorXd direction = left.stableNormalized();
  removed = complement * direction;
  reach = (signals.transpose() * direction).lpNorm<1>();
  // H = I - 2 v v^T takes `direction` to an axis, that of the sign without cancellation; the others then span the rest.
  Eigen::VectorXd v = direction;
  v[0] += std::copysign(1.0, direction[0]);
  v.normalize();
  const Eigen::VectorXd alongComplement = complement * v;
  const Eigen::RowVectorXd alongSignals = v.transpose() * signals;
  const Eigen::Index others = left.size() - 1;
  complement = (complement.rightCols(others) - 2 * alongComplement * v.tail(others).transpose()).eval();
  signals = (signals.bottomRows(others) - 2 * v.tail(others) * alongSignals).eval();
}

}  // namespace gonio::acquisition
