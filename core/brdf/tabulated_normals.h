// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <functional>

#include "core/brdf/direction_sample.h"

namespace gonio {

/// Normals (core/brdf/half_vector_lobe.h) of a rotationally symmetric distribution without a closed-form inverse. The
/// density is piecewise linear in 1 - cos theta_h between 97 values of theta_h, logarithmic from 1e-5 rad; it matches
/// sample() exactly and the distribution approximately.
class TabulatedNormals {
 public:
  /// @param weight unnormalised density at theta_h (rad), such as D cos theta_h, >= 0. Called once per node; non-finite
  /// values count as 0. If all are 0, normals are cosine-weighted.
  explicit TabulatedNormals(const std::function<double(double thetaH)>& weight);

  /// Integral of the weight over the upper hemisphere.
  double total() const { return total_; }

  Direction sample(const glm::dvec2& u) const;
  double density(const Direction& h) const;

 private:
  static constexpr std::size_t circles = 97;

  double total_ = 0;
  std::array<double, circles> density_;     ///< 1/sr
  std::array<double, circles> cumulative_;  ///< fraction inside the circle, 0 to 1
};

}  // namespace gonio
