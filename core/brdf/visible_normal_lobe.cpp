// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/visible_normal_lobe.h"

#include <algorithm>
#include <cmath>

namespace gonio {

Direction VisibleNormalLobe::sample(const Direction& wo, const glm::dvec2& u) const {
  // Section 3 of the paper.
  const Direction stretched = glm::normalize(Direction{alpha * wo.x, alpha * wo.y, wo.z});
  const double across = std::sqrt(stretched.x * stretched.x + stretched.y * stretched.y);
  const Direction tangent = across > 0 ? Direction{-stretched.y / across, stretched.x / across, 0} : Direction{1, 0, 0};
  const Direction bitangent = glm::cross(stretched, tangent);
  const double r = std::sqrt(u.x), phi = 2 * pi * u.y;
  const double s = (1 + stretched.z) / 2;
  const double x = r * std::cos(phi);
  const double y = (1 - s) * std::sqrt(1 - x * x) + s * r * std::sin(phi);
  const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
  const Direction n = x * tangent + y * bitangent + z * stretched;
  const Direction h = glm::normalize(Direction{alpha * n.x, alpha * n.y, std::max(0.0, n.z)});
  return 2 * glm::dot(wo, h) * h - wo;
}

double VisibleNormalLobe::density(const Direction& w, const Direction& wo) const {
  constexpr double minSquaredLength = 1e-24;
  const Direction sum = w + wo;
  const double squaredLength = glm::dot(sum, sum);
  if (!(squaredLength > minSquaredLength) || sum.z < 0) return 0;
  const double alpha2 = alpha * alpha, cosO = std::max(0.0, wo.z);
  const double slope = (sum.x * sum.x + sum.y * sum.y + alpha2 * sum.z * sum.z) / squaredLength;
  const double distribution = alpha2 / (pi * slope * slope);
  return distribution * 0.5 / (cosO + std::sqrt(alpha2 + (1 - alpha2) * cosO * cosO));
}

}  // namespace gonio
