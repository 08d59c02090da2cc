// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness, f0, masking (0 separable, 1 height-correlated), fresnel, edge tint
#include "math.glsl"
#include "fresnel.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_GGX = 7;

vec3 ggxHighlight(SurfaceGeometry g, vec3 p[PARAMETER_COUNT_GGX]) {
  float alpha2 = p[2].x * p[2].x;
  float slope = g.sin2H + alpha2 * g.h.z * g.h.z;
  float distribution = alpha2 / (pi * slope * slope);
  float rootI = sqrt(alpha2 + (1.0 - alpha2) * g.cosI * g.cosI);
  float rootO = sqrt(alpha2 + (1.0 - alpha2) * g.cosO * g.cosO);
  float masking = p[4].x < 0.5 ? 1.0 / ((g.cosI + rootI) * (g.cosO + rootO))
                               : 0.5 / (g.cosO * rootI + g.cosI * rootO);
  return p[1] * (distribution * fresnel(g.cosD, p[3].x, p[6].x, p[5].x) * masking);
}

vec3 evaluate_ggx(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_GGX]) {
  SurfaceGeometry g;
  return surfaceGeometry(wi, wo, g) ? p[0] / pi + ggxHighlight(g, p) : vec3(0.0);
}

// The terms of the sum: the diffuse term, then the highlight.
const int LOBE_COUNT_GGX = 2;
void lobes_ggx(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_GGX], out vec3 lobes[LOBE_COUNT_GGX]) {
  SurfaceGeometry g;
  bool lit = surfaceGeometry(wi, wo, g);
  lobes[0] = lit ? p[0] / pi : vec3(0.0);
  lobes[1] = lit ? ggxHighlight(g, p) : vec3(0.0);
}
