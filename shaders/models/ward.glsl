// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness
#include "math.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_WARD = 3;

vec3 evaluate_ward(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_WARD]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float alpha2 = p[2].x * p[2].x;
  float cos2H = g.h.z * g.h.z;
  // cos^4 leaves float toward the horizon: it goes into the exponent.
  float lobe = exp(-g.sin2H / (cos2H * alpha2) - 2.0 * log(cos2H));
  return p[0] / pi + p[1] * (lobe / (4.0 * pi * alpha2 * g.cosD * g.cosD));
}
