// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/brdf/direction_sample.h"

namespace gonio {

/// For a point of the unit disk: its distance from the viewer's mirror point -wo_xy, as a fraction of the distance to
/// the rim in the same direction, squared; 0 at the mirror point, 1 on the rim. @param deviation Dp = wi_xy + wo_xy of
/// the point.
inline double squaredRimFraction(const glm::dvec2& deviation, const Direction& wo) {
  // The rim lies at the distance d . wo_xy + sqrt((d . wo_xy)^2 + cos^2 theta_o) in the direction d of Dp.
  const double squared = glm::dot(deviation, deviation), along = glm::dot(deviation, glm::dvec2(wo));
  if (!(squared > 0)) return 0;
  const double root = std::sqrt(along * along + wo.z * wo.z * squared);
  // Uses the form without cancellation.
  const double fraction = along > 0 ? squared / (along + root) : (root - along) / (wo.z * wo.z);
  return std::min(1.0, fraction * fraction);
}

/// A lobe (core/brdf/lobe_mixture.h) on the unit disk of projected directions: (n + 1) / pi (1 - u^2)^n with the
/// fraction u of squaredRimFraction(). It integrates to 1 for every viewer: a ray of length L from the mirror point
/// contributes L^2 / (2 pi) per radian, and the integral of L^2 over all rays is twice the area of the disk.
struct RimPowerLobe {
  double exponent;

  Direction sample(const Direction& wo, const glm::dvec2& u) const {
    // A uniformly sampled point has the right azimuth and a uniform squared fraction; only the fraction is changed.
    const double r = std::sqrt(u.x), phi = 2 * pi * u.y;
    glm::dvec2 deviation = glm::dvec2(r * std::cos(phi), r * std::sin(phi)) + glm::dvec2(wo);
    const double uniformFraction = squaredRimFraction(deviation, wo);
    if (uniformFraction > 0)
      deviation *= std::sqrt(-std::expm1(std::log1p(-uniformFraction) / (exponent + 1)) / uniformFraction);
    const glm::dvec2 x = deviation - glm::dvec2(wo);
    return {x.x, x.y, std::sqrt(std::max(0.0, 1 - glm::dot(x, x)))};
  }
  double density(const Direction& w, const Direction& wo) const {
    if (!(w.z > 0)) return 0;
    const double squared = squaredRimFraction(glm::dvec2(w) + glm::dvec2(wo), wo);
    return squared < 1 ? w.z * (exponent + 1) / pi * std::exp(exponent * std::log1p(-squared)) : 0;
  }
};

}  // namespace gonio
