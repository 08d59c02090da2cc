// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness
#include "ward_lobe.glsl"

const int PARAMETER_COUNT_WARD = 3;

vec3 evaluate_ward(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_WARD]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float fade = 1.0 / (sqrt(g.cosI) * sqrt(g.cosO));
  return p[0] / pi + p[1] * (wardLobe(g, p[2].x, p[2].x, 0.0) * fade);
}
