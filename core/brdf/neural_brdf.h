// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/brdf/brdf.h"

namespace gonio {

/// A small network fitted to one measured material: Sztrajman, Rainer, Ritschel and Weyrich, "Neural BRDF
/// Representation and Importance Sampling" (2021). The half and the difference vector (h with azimuth 0) go through two
/// hidden layers of 21 rectified units; the three outputs x give exp(x) - 1, linear RGB in 1/sr without the cosine, cut
/// at 0. Azimuths of the difference vector are folded into half a turn, as in a MERL table, which makes it reciprocal.
/// About 0.3 us per pair.
class NeuralBrdf final : public Brdf {
 public:
  static constexpr std::size_t inputs = 6, hidden = 21, outputs = 3;
  /// Layer by layer, the matrix [input][output], then the bias.
  static constexpr std::size_t weightCount =
      inputs * hidden + hidden + hidden * hidden + hidden + hidden * outputs + outputs;

  /// @throws Error when there are not weightCount weights or one is not finite.
  explicit NeuralBrdf(std::span<const float> weights);

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override;

 private:
  std::array<float, weightCount> weights_;
};

}  // namespace gonio
