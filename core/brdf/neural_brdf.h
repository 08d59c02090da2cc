// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/brdf/brdf.h"
#include "core/coordinates/half_difference.h"

namespace gonio {

/// A small network fitted to one measured material: Sztrajman, Rainer, Ritschel and Weyrich, "Neural BRDF
/// Representation and Importance Sampling" (2021). The inputs are the half vector (rotated to azimuth 0) and the
/// difference vector; two hidden layers have 21 ReLU units each; each of the three outputs x gives max(0, exp(x) - 1):
/// linear RGB, 1/sr, without the cosine. The azimuth of the difference vector is folded to [0, pi), as in a MERL table,
/// which makes the BRDF reciprocal. About 0.3 us per pair.
class NeuralBrdf final : public Brdf {
 public:
  static constexpr std::size_t inputs = 6, hidden = 21, outputs = 3;
  /// Order of the weights: layer by layer, first the matrix [input][output], then the bias.
  static constexpr std::size_t weightCount =
      inputs * hidden + hidden + hidden * hidden + hidden + hidden * outputs + outputs;

  /// @throws Error if the number of weights is not weightCount or one is not finite.
  explicit NeuralBrdf(std::span<const float> weights);

  /// The inputs at half-difference coordinates: half vector and difference vector, the latter's azimuth folded.
  static std::array<float, inputs> inputsAt(const HalfDifference& at);

  std::span<const float, weightCount> weights() const { return weights_; }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override;
  /// By the network's slopes over a set (mean value form) and by its layers in interval arithmetic, whichever is
  /// tighter: 3 us.
  std::shared_ptr<const ValueBound> valueBound() const override;

 private:
  std::array<float, weightCount> weights_;
};

}  // namespace gonio
