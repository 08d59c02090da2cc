// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/parameter_blend.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "core/brdf/weighted_sum.h"
#include "core/support/error.h"

namespace gonio::models {

namespace {

double blend(const ParameterSpec& parameter, std::span<const double> values, std::span<const double> weights) {
  // Equal values stay as they are, to the last bit.
  if (std::equal(values.begin() + 1, values.end(), values.begin())) return values[0];
  const bool geometric = parameter.scale == ParameterScale::logarithmic &&
                         std::all_of(values.begin(), values.end(), [](double value) { return value > 0; });
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (weights[i] > 0) sum += weights[i] * (geometric ? std::log(values[i]) : values[i]);
  return geometric ? std::exp(sum) : sum;
}

}  // namespace

ParameterValues blended(const ModelSpec& spec, std::span<const ParameterValues> ends, std::span<const double> weights) {
  assert(!ends.empty() && ends.size() == weights.size());
  if (const auto whole = indexOfFullWeight(weights)) return ends[*whole];
  ParameterValues result = ends[0];
  std::vector<double> values(ends.size());
  for (std::size_t p = 0; p < spec.parameters.size(); ++p) {
    const ParameterSpec& parameter = spec.parameters[p];
    for (int channel = 0; channel < 3; ++channel) {
      for (std::size_t i = 0; i < ends.size(); ++i) values[i] = ends[i].values[p][channel];
      if (!parameter.choices.empty() && !std::equal(values.begin() + 1, values.end(), values.begin()))
        throw Error("the choices of " + std::string(parameter.id) + " differ; they cannot be blended");
      result.values[p][channel] = blend(parameter, values, weights);
    }
  }
  return result;
}

}  // namespace gonio::models
