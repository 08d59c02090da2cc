// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, exponent, normalisation (0 half-vector, 1 unit-albedo, 2 none)
#include "cosine_power.glsl"

const int PARAMETER_COUNT_BLINN_PHONG = 4;

float blinnPhongNormaliser(float n, float choice) {
  if (choice < 0.5) return (n + 2.0) / (8.0 * pi);
  if (choice < 1.5) return halfVectorNormalisation(n);
  return 1.0;
}

vec3 evaluate_blinn_phong(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_BLINN_PHONG]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float n = p[2].x;
  return p[0] / pi + p[1] * (blinnPhongNormaliser(n, p[3].x) * halfVectorPower(g, n));
}
