// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, exponent
#include "cosine_power.glsl"

const int PARAMETER_COUNT_MODIFIED_PHONG = 3;

vec3 evaluate_modified_phong(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_MODIFIED_PHONG]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  return p[0] / pi + p[1] * (reflectionNormalisation(p[2].x) * reflectionPower(wi, wo, p[2].x));
}
