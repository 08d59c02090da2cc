// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, exponent, lobe (0 reflection, 1 half-vector)
#include "cosine_power.glsl"

const int PARAMETER_COUNT_LEWIS = 4;

vec3 evaluate_lewis(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_LEWIS]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float n = p[2].x;
  float lobe = p[3].x < 0.5 ? reflectionNormalisation(n) * reflectionPower(wi, wo, n)
                            : halfVectorNormalisation(n) * halfVectorPower(g, n);
  return p[0] / pi + p[1] * lobe;
}
