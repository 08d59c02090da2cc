// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, volume, specular, roughness, f0, tau (rad), Omega (rad), fresnel, edge tint
#include "beckmann.glsl"
#include "fresnel.glsl"

const int PARAMETER_COUNT_BEARD_MAXWELL = 9;

vec3 evaluate_beard_maxwell(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_BEARD_MAXWELL]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float thetaH = acuteAngle(sqrt(g.sin2H), g.h.z);
  float thetaD = acuteAngle(0.5 * length(wi - wo), g.cosD);
  float shadowed = exp(-2.0 * thetaD / p[5].x), sum = p[6].x + thetaH;
  float obscuration = sum > 0.0 ? (p[6].x + thetaH * shadowed) / sum : shadowed;
  float surface = beckmannDistribution(g, p[3].x) * fresnel(g.cosD, p[4].x, p[8].x, p[7].x) * obscuration /
                  (4.0 * g.cosI * g.cosO);
  return p[0] / pi + p[1] * (2.0 / (pi * (g.cosI + g.cosO))) + p[2] * surface;
}
