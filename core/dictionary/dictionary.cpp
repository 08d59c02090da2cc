// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/dictionary.h"

#include <algorithm>
#include <numbers>

#include "core/support/error.h"

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

Dictionary inBothOrders(const Dictionary& dictionary) {
  Dictionary result = dictionary;
  const Eigen::MatrixXd atoms = dictionary.modes[0] / std::numbers::sqrt2;
  Eigen::MatrixXd& both = result.modes[0];
  both.resize(2 * atoms.rows(), 2 * atoms.cols());
  for (Eigen::Index a = 0; a < atoms.cols(); ++a) {
    both.col(2 * a) << atoms.col(a), atoms.col(a);
    both.col(2 * a + 1) << atoms.col(a), -atoms.col(a);
  }
  return result;
}

Ensemble inBothOrders(const Ensemble& ensemble) {
  if (!ensemble.grid.reciprocal) return ensemble;
  Ensemble result{ensemble.grid.wholeCircle(), {}, ensemble.learnedFrom, ensemble.scaled};
  for (const Dictionary& dictionary : ensemble.dictionaries) result.dictionaries.push_back(inBothOrders(dictionary));
  return result;
}

Ensemble joined(Ensemble first, const Ensemble& second) {
  if (first.grid != second.grid) throw Error("found dictionaries of different grids, expected one grid");
  if (first.scaled != second.scaled)
    throw Error("found dictionaries with and without cell scaling, expected the same for all");
  first.dictionaries.insert(first.dictionaries.end(), second.dictionaries.begin(), second.dictionaries.end());
  for (const std::string& name : second.learnedFrom)
    if (std::ranges::find(first.learnedFrom, name) == first.learnedFrom.end()) first.learnedFrom.push_back(name);
  return first;
}

SparseCode inBothOrders(const SparseCode& code) {
  if (code.hasBothOrders()) return code;
  SparseCode result = code;
  result.grid = code.grid.wholeCircle();
  for (ChannelCode& channel : result.channels) {
    channel.step *= std::numbers::sqrt2_v<float>;
    // Twice the atoms of mode 0, of which this is the even one: the number of all atoms before it doubles too.
    for (Coefficient<float>& c : channel.coefficients) c = {2 * c.index, c.value * std::numbers::sqrt2_v<float>};
  }
  return result;
}

Dictionary dictionaryOf(const Ensemble& ensemble, const SparseCode& code, std::size_t channel) {
  const Dictionary& own = ensemble.dictionaries[std::size_t(code.channels[channel].dictionary)];
  return code.grid == ensemble.grid ? own : inBothOrders(own);
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
