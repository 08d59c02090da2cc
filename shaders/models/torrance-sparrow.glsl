// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness, f0, fresnel, edge tint, normalisation, then K, which takes an integral.
#include "math.glsl"
#include "fresnel.glsl"
#include "v_cavity.glsl"

const int PARAMETER_COUNT_TORRANCE_SPARROW = 8;

vec3 evaluate_torrance_sparrow(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_TORRANCE_SPARROW]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float tilt = acuteAngle(sqrt(g.sin2H), g.h.z) / p[2].x;
  float distribution = p[7].x * exp(-tilt * tilt);
  return p[0] / pi +
         p[1] * (0.25 * distribution * fresnel(g.cosD, p[3].x, p[5].x, p[4].x) * vCavityOverCosines(g));
}
