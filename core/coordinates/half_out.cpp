// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/half_out.h"

#include <cmath>

#include "core/coordinates/half_difference.h"

namespace gonio {

HalfOut toHalfOut(const Direction& wi, const Direction& wo) {
  const Direction sum = wi + wo;
  if (!(glm::dot(sum, sum) > minSquaredHalfLength)) return {.valid = false};
  const double across = wo.x * sum.y - wo.y * sum.x, along = wo.x * sum.x + wo.y * sum.y;
  return {.thetaO = polarAngle(wo),
          .thetaH = std::atan2(std::hypot(sum.x, sum.y), sum.z),
          .phiH = across == 0 && along == 0 ? 0 : std::atan2(across, along)};
}

HalfOutDirections fromHalfOut(const HalfOut& c) {
  const Direction wo = fromSpherical(c.thetaO, 0), half = fromSpherical(c.thetaH, c.phiH);
  const double cosD = glm::dot(wo, half);
  Direction wi = 2 * cosD * half - wo;
  const bool valid = c.valid && cosD > 0 && !isBelowHorizon(wi);
  if (valid && wi.z < 0) wi.z = 0;
  return {.pair = {wi, wo}, .valid = valid};
}

}  // namespace gonio
