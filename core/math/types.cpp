// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/types.h"

#include <cmath>

#include "core/math/fast_functions.h"

namespace gonio {

Direction fromSpherical(double theta, double phi) {
  const double s = std::sin(theta);
  return {s * std::cos(phi), s * std::sin(phi), std::cos(theta)};
}

double polarAngle(const Direction& w) { return fastAtan2(std::sqrt(w.x * w.x + w.y * w.y), w.z); }

double azimuth(const Direction& w) { return (w.x == 0 && w.y == 0) ? 0.0 : fastAtan2(w.y, w.x); }

}  // namespace gonio
