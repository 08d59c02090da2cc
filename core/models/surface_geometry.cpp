// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/surface_geometry.h"

#include <algorithm>
#include <cmath>

namespace gonio::models {

bool surfaceGeometry(const DirectionPair& pair, SurfaceGeometry& g) {
  constexpr double minSquaredHalfLength = 1e-24;
  if (!(pair.wi.z > horizonTolerance) || !(pair.wo.z > horizonTolerance)) return false;
  const Direction sum = pair.wi + pair.wo;
  const double squaredLength = glm::dot(sum, sum);
  if (squaredLength < minSquaredHalfLength) return false;
  g.wi = pair.wi;
  g.wo = pair.wo;
  g.half = sum / std::sqrt(squaredLength);
  g.cosI = std::min(1.0, pair.wi.z);
  g.cosO = std::min(1.0, pair.wo.z);
  // |wi + wo| = 2 cos theta_d for unit vectors.
  g.cosD = std::min(1.0, std::sqrt(squaredLength) / 2);
  g.sin2H = g.half.x * g.half.x + g.half.y * g.half.y;
  g.oneMinusCosH = g.sin2H / (1 + g.half.z);
  return true;
}

}  // namespace gonio::models
