// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, then of each of three lobes reflectance, edge, roughness
#include "math.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_LAYERED = 10;

vec3 layeredLobe(SurfaceGeometry g, vec3 normal, vec3 edge, float alpha) {
  float alpha2 = alpha * alpha;
  float slope = g.sin2H + alpha2 * g.h.z * g.h.z;
  float rootI = sqrt(alpha2 + (1.0 - alpha2) * g.cosI * g.cosI);
  float rootO = sqrt(alpha2 + (1.0 - alpha2) * g.cosO * g.cosO);
  float m = 1.0 - g.cosD, m2 = m * m, s = m2 * m2 * m;
  return alpha2 / (pi * slope * slope) * 0.5 / (g.cosO * rootI + g.cosI * rootO) * mix(normal, edge, s);
}

// One part of the sum alone: the body, then the lobes.
const int LOBE_COUNT_LAYERED = 4;
vec3 lobe_layered(int part, vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_LAYERED]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  if (part == 0) return p[0] / pi;
  int first = 3 * part - 2;
  return layeredLobe(g, p[first], p[first + 1], p[first + 2].x);
}

vec3 evaluate_layered(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_LAYERED]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  vec3 value = p[0] / pi;
  for (int lobe = 1; lobe < PARAMETER_COUNT_LAYERED; lobe += 3)
    value += layeredLobe(g, p[lobe], p[lobe + 1], p[lobe + 2].x);
  return value;
}
