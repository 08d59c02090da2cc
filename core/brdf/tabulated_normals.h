// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <functional>

#include "core/brdf/direction_sample.h"

namespace gonio {

/// Normals (core/brdf/half_vector_lobe.h) of a rotationally symmetric distribution that has no closed inverse: between
/// circles of theta_h, close at the pole (logarithmic from 1e-5 rad) and wide at the horizon, the density is linear in
/// 1 - cos theta_h. That density is exact for the draws, and about that of the distribution.
class TabulatedNormals {
 public:
  /// @param weight of theta_h (rad), not negative: about D cos theta_h, of any scale. Called once a circle;
  /// where it is not finite it counts as 0; 0 everywhere gives cosine-weighted normals.
  explicit TabulatedNormals(const std::function<double(double thetaH)>& weight);

  /// Integral of the weight over the upper hemisphere.
  double total() const { return total_; }

  Direction sample(const glm::dvec2& u) const;
  double density(const Direction& h) const;

 private:
  static constexpr std::size_t circles = 97;

  double total_ = 0;
  std::array<double, circles> density_;     ///< 1/sr
  std::array<double, circles> cumulative_;  ///< share inside the circle: 0 to 1
};

}  // namespace gonio
