// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/math/fast_functions.h"
#include "core/models/surface_geometry.h"

namespace gonio::models {

/// Beckmann's distribution of facets, exp(-tan^2 theta_h / m^2) / (pi m^2 cos^4 theta_h), 1/sr: D cos theta_h
/// integrates to 1 over the hemisphere (Beckmann and Spizzichino 1963; Cook and Torrance 1982 omit the 1/pi). O(1).
/// @param inverseM2 1 / m^2, m the root mean square slope.
inline double beckmannDistribution(const SurfaceGeometry& g, double inverseM2) {
  const double cos2H = g.half.z * g.half.z;
  return fastExp(-g.sin2H / cos2H * inverseM2) * inverseM2 / (pi * cos2H * cos2H);
}

}  // namespace gonio::models
