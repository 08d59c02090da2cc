// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: the numerator's coefficients of 1, x, y, x^2, x y, y^2, then the denominator's of all but the first
#include "math.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_RATIONAL = 11;

vec3 evaluate_rational(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_RATIONAL]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float x = g.oneMinusCosH, y = 0.25 * dot(wi - wo, wi - wo) / (1.0 + g.cosD);  // 1 - cos theta_d
  vec3 above = p[0] + p[1] * x + p[2] * y + p[3] * (x * x) + p[4] * (x * y) + p[5] * (y * y);
  float below = 1.0 + p[6].x * x + p[7].x * y + p[8].x * (x * x) + p[9].x * (x * y) + p[10].x * (y * y);
  return above / below;
}
