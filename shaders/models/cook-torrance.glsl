// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness, f0, normalisation (0 walter, 1 ngan, 2 original-1982), fresnel, edge tint
#include "beckmann.glsl"
#include "fresnel.glsl"
#include "v_cavity.glsl"

const int PARAMETER_COUNT_COOK_TORRANCE = 7;

vec3 evaluate_cook_torrance(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_COOK_TORRANCE]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float distribution = beckmannDistribution(g, p[2].x);
  float denominator = p[4].x < 0.5 ? 4.0 : (p[4].x < 1.5 ? pi : 1.0);
  return p[0] / pi +
         p[1] * (distribution * fresnel(g.cosD, p[3].x, p[6].x, p[5].x) * vCavityOverCosines(g) / denominator);
}
