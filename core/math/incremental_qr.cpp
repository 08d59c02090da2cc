// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/incremental_qr.h"

#include <Eigen/Dense>
#include <algorithm>

namespace gonio {

IncrementalQr::IncrementalQr(Eigen::Index rows, Eigen::Index maxColumns)
    : q_(rows, std::min(rows, maxColumns)), r_(Eigen::MatrixXd::Zero(q_.cols(), q_.cols())) {}

bool IncrementalQr::append(const Eigen::Ref<const Eigen::VectorXd>& column) {
  if (size_ == q_.cols()) return false;
  const double norm = column.stableNorm();
  if (!(norm > 0)) return false;
  // Unit length first: neither tiny nor huge columns leave the range.
  Eigen::VectorXd rest = column / norm;
  Eigen::VectorXd along = Eigen::VectorXd::Zero(size_);
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::VectorXd part = q().transpose() * rest;
    rest.noalias() -= q() * part;
    along += part;
  }
  const double left = rest.norm();
  if (left <= collinear) return false;
  q_.col(size_) = rest / left;
  r_.col(size_).head(size_) = along * norm;
  r_(size_, size_) = left * norm;
  ++size_;
  return true;
}

Eigen::VectorXd IncrementalQr::solve(const Eigen::Ref<const Eigen::VectorXd>& b) const {
  return r().triangularView<Eigen::Upper>().solve(b);
}

}  // namespace gonio
