// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/neural_brdf.h"

#include <algorithm>
#include <cmath>

#include "core/support/error.h"

namespace gonio {

namespace {

/// One layer without its activation; `weights` is moved behind it.
template <std::size_t inputs, std::size_t outputs>
std::array<float, outputs> layer(const float*& weights, const std::array<float, inputs>& from) {
  std::array<float, outputs> to;
  std::copy_n(weights + inputs * outputs, outputs, to.begin());
  for (std::size_t i = 0; i < inputs; ++i)
    for (std::size_t o = 0; o < outputs; ++o) to[o] += from[i] * weights[i * outputs + o];
  weights += inputs * outputs + outputs;
  return to;
}

template <std::size_t size>
std::array<float, size> rectified(std::array<float, size> values) {
  for (float& value : values) value = std::max(value, 0.0f);
  return values;
}

}  // namespace

std::array<float, NeuralBrdf::inputs> NeuralBrdf::inputsAt(const HalfDifference& at) {
  const double phi = foldPhiD(at.phiD);
  const double across = std::sin(at.thetaD);
  return {float(std::sin(at.thetaH)),    0,
          float(std::cos(at.thetaH)),    float(across * std::cos(phi)),
          float(across * std::sin(phi)), float(std::cos(at.thetaD))};
}

NeuralBrdf::NeuralBrdf(std::span<const float> weights) {
  if (weights.size() != weightCount)
    throw Error("found a neural BRDF with " + std::to_string(weights.size()) + " weights, expected " +
                std::to_string(weightCount));
  for (std::size_t i = 0; i < weightCount; ++i)
    if (!std::isfinite(weights[i]))
      throw Error("weight " + std::to_string(i) + " of a neural BRDF is " + std::to_string(weights[i]) +
                  ", expected a finite number");
  std::copy(weights.begin(), weights.end(), weights_.begin());
}

void NeuralBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
  // exp(80) is within the range of float.
  constexpr float maxExponent = 80;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [wi, wo] = pairs[i];
    const HalfDifference at = toHalfDifference(wi, wo);
    values[i] = Rgb(0);
    if (isBelowHorizon(wi) || isBelowHorizon(wo) || !at.valid) continue;
    const float* weights = weights_.data();
    const auto first = rectified(layer<inputs, hidden>(weights, inputsAt(at)));
    const auto second = rectified(layer<hidden, hidden>(weights, first));
    const auto result = layer<hidden, outputs>(weights, second);
    for (int c = 0; c < 3; ++c)
      values[i][c] = std::max(0.0f, std::expm1(std::min(result[std::size_t(c)], maxExponent)));
  }
}

}  // namespace gonio
