// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/models/beckmann.h.
#include "math.glsl"
#include "surface_geometry.glsl"

float beckmannDistribution(SurfaceGeometry g, float m) {
  float cos2H = g.h.z * g.h.z, m2 = m * m;
  // cos^4 leaves float toward the horizon: it goes into the exponent.
  return exp(-g.sin2H / (cos2H * m2) - 2.0 * log(cos2H)) / (pi * m2);
}
