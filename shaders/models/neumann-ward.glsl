// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness x, roughness y, rotation; behind them its cosine and sine
#include "grain.glsl"
#include "ward_lobe.glsl"

const int PARAMETER_COUNT_NEUMANN_WARD = 6;

// The terms of the sum: the diffuse term, then the highlight.
const int LOBE_COUNT_NEUMANN_WARD = 2;
void lobes_neumann_ward(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_NEUMANN_WARD], out vec3 lobes[LOBE_COUNT_NEUMANN_WARD]) {
  SurfaceGeometry g;
  lobes[0] = lobes[1] = vec3(0.0);
  if (!surfaceGeometry(wi, wo, g)) return;
  g.h = inGrain(g.h, p[5].xy);
  lobes[0] = p[0] / pi;
  lobes[1] = p[1] * (wardLobe(g, p[2].x, p[3].x, 0.0) / max(g.cosI, g.cosO));
}

vec3 evaluate_neumann_ward(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_NEUMANN_WARD]) {
  vec3 lobes[LOBE_COUNT_NEUMANN_WARD];
  lobes_neumann_ward(wi, wo, p, lobes);
  return lobes[0] + lobes[1];
}
