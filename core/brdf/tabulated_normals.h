// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <functional>

#include "core/brdf/direction_sample.h"

namespace gonio {

/// Normals (core/brdf/half_vector_lobe.h) of a rotationally symmetric distribution that has no closed inverse: constant
/// on rings of theta_h, narrow at the pole (logarithmic from 1e-5 rad), wide at the horizon. The density is that of the
/// rings, so it is exact for the draws, and about that of the distribution.
class TabulatedNormals {
 public:
  /// @param weight of theta_h (rad), not negative: about D cos theta_h, of any scale. Called once a ring; a weight
  /// of nothing anywhere, and one that is not finite, count as if it were 0; all 0 gives cosine-weighted normals.
  explicit TabulatedNormals(const std::function<double(double thetaH)>& weight);

  Direction sample(const glm::dvec2& u) const;
  double density(const Direction& h) const;

 private:
  static constexpr int rings = 96;

  std::array<double, rings + 1> cumulative_;  ///< of the rings' shares: 0 to 1
};

}  // namespace gonio
