// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, roughness (rad)
#include "math.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_OREN_NAYAR = 2;

vec3 evaluate_oren_nayar(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_OREN_NAYAR]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float sigma2 = p[1].x * p[1].x;
  float a = 1.0 - 0.5 * sigma2 / (sigma2 + 0.33), b = 0.45 * sigma2 / (sigma2 + 0.09);
  float across = max(0.0, dot(wi.xy, wo.xy)) / max(g.cosI, g.cosO);
  return p[0] / pi * (a + b * across);
}
