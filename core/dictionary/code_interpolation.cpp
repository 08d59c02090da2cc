// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_interpolation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>

#include "core/brdf/weighted_sum.h"
#include "core/dictionary/decode.h"
#include "core/dictionary/mode_products.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

void check(const Ensemble& ensemble, std::span<const SparseCode> codes, std::span<const double> weights) {
  if (codes.empty()) throw Error("interpolation: found no code, expected at least one");
  checkWeights(weights, codes.size());
  for (const SparseCode& code : codes) {
    checkCode(ensemble, code);
    if (code.transform != codes.front().transform)
      throw Error("interpolation: the codes have different transforms, " +
                  std::string(dataTransformNames[std::size_t(codes.front().transform)]) + " and " +
                  std::string(dataTransformNames[std::size_t(code.transform)]) + ": encode one of them again");
    if (code.scaled != codes.front().scaled)
      throw Error(
          "interpolation: found one code with cell scaling and one without, expected the same for all: encode them "
          "with one dictionary");
  }
}

/// Weighted sum of codes that share a dictionary: its coefficients are those of both.
std::vector<Coefficient<float>> sumOverOneDictionary(std::span<const SparseCode> codes, std::span<const double> weights,
                                                     std::size_t channel) {
  std::map<std::uint32_t, double> sums;
  for (std::size_t i = 0; i < codes.size(); ++i)
    for (const Coefficient<float>& c : codes[i].channels[channel].coefficients)
      sums[c.index] += weights[i] * double(c.value);
  std::vector<Coefficient<float>> result;
  for (const auto& [index, value] : sums)
    if (value != 0) result.push_back({index, float(value)});
  return result;
}

/// The dense sum over the first code's dictionary.
Eigen::ArrayXd sumOverFirst(const Ensemble& ensemble, std::span<const SparseCode> codes,
                            std::span<const double> weights, std::size_t channel) {
  const Dictionary first = dictionaryOf(ensemble, codes.front(), channel);
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(Eigen::Index(codes.front().grid.size())), carried(sum.size());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const ChannelCode& code = codes[i].channels[channel];
    if (weights[i] == 0) continue;
    if (code.dictionary == codes.front().channels[channel].dictionary) {
      for (const Coefficient<float>& c : code.coefficients) sum[c.index] += weights[i] * double(c.value);
      continue;
    }
    const auto rotations = rotationsBetween(first, dictionaryOf(ensemble, codes[i], channel));
    compose<double>(rotations, coefficientsIn<double>(code.coefficients), carried.data());
    sum += weights[i] * carried;
  }
  return sum;
}

ChannelCode interpolateChannel(const Ensemble& ensemble, std::span<const SparseCode> codes,
                               std::span<const double> weights, std::size_t channel, std::size_t coefficients) {
  ChannelCode result;
  result.dictionary = codes.front().channels[channel].dictionary;
  double lowest = 0, highest = 0, largestValue = 0;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    lowest += weights[i] * double(codes[i].channels[channel].lowest);
    highest += weights[i] * double(codes[i].channels[channel].highest);
    largestValue += weights[i] * double(codes[i].channels[channel].largestValue);
  }
  result.lowest = float(lowest);
  result.highest = float(highest);
  result.largestValue = float(std::min(largestValue, double(std::numeric_limits<float>::max())));
  const bool fraction = std::all_of(codes.begin(), codes.end(), [&](const SparseCode& code) {
    return code.channels[channel].dictionary == result.dictionary;
  });
  if (fraction) {
    result.coefficients = sumOverOneDictionary(codes, weights, channel);
  } else {
    const Eigen::ArrayXd sum = sumOverFirst(ensemble, codes, weights, channel);
    std::vector<Coefficient<double>> largest;
    selectLargest(std::span(sum.data(), std::size_t(sum.size())), coefficients, largest);
    result.coefficients = coefficientsIn<float>(largest);
  }
  std::sort(result.coefficients.begin(), result.coefficients.end(), isLarger<float>);
  result.coefficients.resize(std::min(result.coefficients.size(), coefficients));
  return result;
}

}  // namespace

std::array<Eigen::MatrixXd, 3> rotationsBetween(const Dictionary& u, const Dictionary& v) {
  std::array<Eigen::MatrixXd, 3> rotations;
  for (std::size_t mode = 0; mode < 3; ++mode) {
    const Eigen::MatrixXd product = u.modes[mode].transpose() * v.modes[mode];
    // A product of square orthonormal matrices is its own polar factor: no singular values are needed.
    const bool square = u.modes[mode].rows() == u.modes[mode].cols() && v.modes[mode].rows() == v.modes[mode].cols();
    rotations[mode] = square ? product : orthogonalProcrustes(product);
  }
  return rotations;
}

SparseCode interpolateCodes(const Ensemble& ensemble, std::span<const SparseCode> codes,
                            std::span<const double> weights, std::size_t coefficients) {
  check(ensemble, codes, weights);
  if (const auto whole = indexOfFullWeight(weights)) return codes[*whole];
  if (std::ranges::any_of(codes, &SparseCode::hasBothOrders) &&
      !std::ranges::all_of(codes, &SparseCode::hasBothOrders)) {
    std::vector<SparseCode> both;
    for (const SparseCode& code : codes) both.push_back(inBothOrders(code));
    return interpolateCodes(ensemble, both, weights, coefficients);
  }
  SparseCode result = codes.front();
  result.hasLargestValues = std::ranges::any_of(codes, &SparseCode::hasLargestValues);
  parallelForBlocks(3, 1, [&](std::size_t channel, std::size_t) {
    result.channels[channel] = interpolateChannel(ensemble, codes, weights, channel, coefficients);
  });
  return result;
}

}  // namespace gonio::dictionary
