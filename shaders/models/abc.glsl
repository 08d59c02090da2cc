// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, A, B, C, index of refraction, normalisation (0 pi, 1 one), fresnel, edge tint
#include "math.glsl"
#include "fresnel.glsl"
#include "v_cavity.glsl"

const int PARAMETER_COUNT_ABC = 8;

vec3 evaluate_abc(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_ABC]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float lobe = exp(-p[3].x * logOnePlus(p[2].x * g.oneMinusCosH));
  float ratio = (p[4].x - 1.0) / (p[4].x + 1.0);
  float denominator = p[5].x < 0.5 ? pi : 1.0;
  return p[0] / pi + p[1] * (lobe * fresnel(g.cosD, ratio * ratio, p[7].x, p[6].x) * vCavityOverCosines(g) / denominator);
}
