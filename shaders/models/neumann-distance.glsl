// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, width, falloff (0 gaussian, 1 rational), tail power
#include "math.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_NEUMANN_DISTANCE = 5;

vec3 evaluate_neumann_distance(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_NEUMANN_DISTANCE]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  vec2 deviation = wi.xy + wo.xy;
  float s2 = p[2].x * p[2].x, c = p[4].x;
  float distance2 = dot(deviation, deviation) / s2;
  float lobe = p[3].x < 0.5 ? exp(-distance2) : (c - 1.0) * exp(-c * logOnePlus(distance2));
  return p[0] / pi + p[1] * (lobe / (pi * s2));
}
