// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness x, roughness y, rotation; behind them its cosine and sine
#include "grain.glsl"
#include "ward_lobe.glsl"

const int PARAMETER_COUNT_NEUMANN_WARD = 6;

vec3 evaluate_neumann_ward(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_NEUMANN_WARD]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  g.h = inGrain(g.h, p[5].xy);
  return p[0] / pi + p[1] * (wardLobe(g, p[2].x, p[3].x, 0.0) / max(g.cosI, g.cosO));
}
