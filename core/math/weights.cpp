// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/weights.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/support/error.h"

namespace gonio {

void checkWeights(std::span<const double> weights, std::size_t materials) {
  constexpr double slack = 1e-9;
  if (weights.size() != materials)
    throw Error("found " + std::to_string(weights.size()) + " weights, expected " + std::to_string(materials) +
                ": one per material");
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] >= 0 && weights[i] <= 1))
      throw Error("the weight of material " + std::to_string(i + 1) + " is " + std::to_string(weights[i]) +
                  "; expected a number from 0 to 1");
    sum += weights[i];
  }
  if (std::abs(sum - 1) > slack) throw Error("the weights add up to " + std::to_string(sum) + "; expected 1");
}

std::optional<std::size_t> indexOfFullWeight(std::span<const double> weights) {
  const auto whole = std::find(weights.begin(), weights.end(), 1.0);
  if (whole == weights.end()) return {};
  return std::size_t(whole - weights.begin());
}

}  // namespace gonio
