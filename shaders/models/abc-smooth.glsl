// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, A, B, C, index of refraction, fresnel, edge tint, angle of the Fresnel term (0 exact, 1 projected)
#include "math.glsl"
#include "fresnel.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_ABC_SMOOTH = 8;

vec3 evaluate_abc_smooth(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_ABC_SMOOTH]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  vec2 sum = wi.xy + wo.xy;
  float cosD = p[7].x < 0.5 ? g.cosD : min(1.0, length(vec2(g.cosD, 0.5 * (g.cosI - g.cosO))));
  float ratio = (p[4].x - 1.0) / (p[4].x + 1.0);
  float lobe = exp(-p[3].x * logOnePlus(p[2].x * dot(sum, sum)));
  return p[0] / pi + p[1] * (lobe * fresnel(cosD, ratio * ratio, p[6].x, p[5].x));
}
