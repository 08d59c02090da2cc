// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, exponent x, exponent y, f0, fresnel, edge tint,
//    diffuse term (0 coupled, 1 lambert), rotation; behind them its cosine and sine
#include "cosine_power.glsl"
#include "fresnel.glsl"
#include "grain.glsl"

const int PARAMETER_COUNT_ASHIKHMIN_SHIRLEY = 10;

float entering(float cosine) {
  float m = 1.0 - 0.5 * cosine, m2 = m * m;
  return 1.0 - m2 * m2 * m;
}

// The terms of the sum: the diffuse term, then the highlight.
const int LOBE_COUNT_ASHIKHMIN_SHIRLEY = 2;
void lobes_ashikhmin_shirley(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_ASHIKHMIN_SHIRLEY], out vec3 lobes[LOBE_COUNT_ASHIKHMIN_SHIRLEY]) {
  SurfaceGeometry g;
  lobes[0] = lobes[1] = vec3(0.0);
  if (!surfaceGeometry(wi, wo, g)) return;
  g.h = inGrain(g.h, p[9].xy);
  float nx = p[2].x, ny = p[3].x, f0 = p[4].x;
  float exponent = g.sin2H > 0.0 ? (nx * g.h.x * g.h.x + ny * g.h.y * g.h.y) / g.sin2H : 0.0;
  float lobe = sqrt((nx + 1.0) * (ny + 1.0)) / (8.0 * pi) * halfVectorPower(g, exponent) *
               fresnel(g.cosD, f0, p[6].x, p[5].x) / (g.cosD * max(g.cosI, g.cosO));
  float shape = p[7].x < 0.5 ? 28.0 / 23.0 * (1.0 - f0) * entering(g.cosI) * entering(g.cosO) : 1.0;
  lobes[0] = p[0] * (shape / pi);
  lobes[1] = p[1] * lobe;
}

vec3 evaluate_ashikhmin_shirley(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_ASHIKHMIN_SHIRLEY]) {
  vec3 lobes[LOBE_COUNT_ASHIKHMIN_SHIRLEY];
  lobes_ashikhmin_shirley(wi, wo, p, lobes);
  return lobes[0] + lobes[1];
}
