// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, exponent, normalisation (0 energy, 1 none)
#include "cosine_power.glsl"

const int PARAMETER_COUNT_NEUMANN_BLINN = 4;

vec3 evaluate_neumann_blinn(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_NEUMANN_BLINN]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float n = p[2].x;
  float factor = p[3].x < 0.5 ? (n + 1.0) / (8.0 * pi) : 1.0;
  return p[0] / pi + p[1] * (factor * halfVectorPower(g, n) / max(g.cosI, g.cosO));
}
