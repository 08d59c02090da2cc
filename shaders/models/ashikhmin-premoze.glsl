// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness x, roughness y, f0, fresnel, edge tint, rotation; behind them its cosine and sine
#include "ward_lobe.glsl"
#include "fresnel.glsl"
#include "grain.glsl"

const int PARAMETER_COUNT_ASHIKHMIN_PREMOZE = 9;

vec3 evaluate_ashikhmin_premoze(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_ASHIKHMIN_PREMOZE]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  g.h = inGrain(g.h, p[8].xy);
  float reflectance = fresnel(g.cosD, p[4].x, p[6].x, p[5].x);
  return p[0] / pi + p[1] * (wardLobe(g, p[2].x, p[3].x, 0.0) * reflectance / (g.cosI + g.cosO - g.cosI * g.cosO));
}
