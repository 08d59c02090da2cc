// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse
#include "math.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_LAMBERT = 1;

vec3 evaluate_lambert(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_LAMBERT]) {
  SurfaceGeometry g;
  return surfaceGeometry(wi, wo, g) ? p[0] / pi : vec3(0.0);
}
