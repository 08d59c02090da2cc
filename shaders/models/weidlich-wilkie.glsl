// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness, f0, coat, coat roughness, coat index, absorption, fresnel, edge tint
#include "beckmann.glsl"
#include "fresnel.glsl"
#include "v_cavity.glsl"

const int PARAMETER_COUNT_WEIDLICH_WILKIE = 10;

SurfaceGeometry refractedGeometry(SurfaceGeometry g, float eta) {
  float contrast = (eta - 1.0) * (eta + 1.0), root = sqrt(contrast + g.cosD * g.cosD);
  float s = contrast / (root + g.cosD);
  SurfaceGeometry inside = g;
  inside.cosI = (g.cosI + s * g.h.z) / eta;
  inside.cosO = (g.cosO + s * g.h.z) / eta;
  inside.cosD = root / eta;
  return inside;
}

vec3 evaluate_weidlich_wilkie(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_WEIDLICH_WILKIE]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float eta = p[6].x;
  float folded = vCavityOverCosines(g), unmasked = folded * g.cosI * g.cosO;
  float transmitted = fresnelTransmittance(g.cosD, eta);
  float leaving = transmitted * ((1.0 - unmasked) + transmitted * unmasked);
  SurfaceGeometry inside = refractedGeometry(g, eta);
  vec3 absorbed = exp(-p[7] * (1.0 / inside.cosI + 1.0 / inside.cosO));
  float base = 0.25 * beckmannDistribution(g, p[2].x) * fresnel(inside.cosD, p[3].x, p[9].x, p[8].x) *
               vCavityOverCosines(inside);
  float surface = 0.25 * beckmannDistribution(g, p[5].x) * fresnelDielectric(g.cosD, eta) * folded;
  return p[4] * surface + (p[0] / pi + p[1] * base) * absorbed * leaving;
}
