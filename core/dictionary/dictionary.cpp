// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/dictionary.h"

#include <algorithm>

namespace gonio::dictionary {

std::size_t SparseCode::coefficients() const {
  std::size_t most = 0;
  for (const ChannelCode& channel : channels) most = std::max(most, channel.coefficients.size());
  return most;
}

SparseCode SparseCode::truncated(std::size_t coefficients) const {
  SparseCode result = *this;
  for (ChannelCode& channel : result.channels)
    channel.coefficients.resize(std::min(channel.coefficients.size(), coefficients));
  return result;
}

std::size_t Ensemble::bytes() const {
  std::size_t numbers = 0;
  for (const Dictionary& dictionary : dictionaries)
    for (const Eigen::MatrixXd& mode : dictionary.modes) numbers += std::size_t(mode.size());
  return numbers * sizeof(float);
}

double orthonormalityError(const Eigen::MatrixXd& matrix) {
  return (matrix.transpose() * matrix - Eigen::MatrixXd::Identity(matrix.cols(), matrix.cols())).cwiseAbs().maxCoeff();
}

double orthonormalityError(const Ensemble& ensemble) {
  double worst = 0;
  for (const Dictionary& dictionary : ensemble.dictionaries)
    for (const Eigen::MatrixXd& mode : dictionary.modes) worst = std::max(worst, orthonormalityError(mode));
  return worst;
}

Eigen::MatrixXd polished(const Eigen::MatrixXd& nearlyOrthonormal) {
  const Eigen::Index n = nearlyOrthonormal.cols();
  return nearlyOrthonormal *
         (1.5 * Eigen::MatrixXd::Identity(n, n) - 0.5 * nearlyOrthonormal.transpose() * nearlyOrthonormal);
}

}  // namespace gonio::dictionary
