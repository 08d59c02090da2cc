// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, three times (strength, roughness, f0), normalisation (0 walter, 1 rump), fresnel, edge tint
#include "beckmann.glsl"
#include "fresnel.glsl"
#include "v_cavity.glsl"

const int PARAMETER_COUNT_CAR_PAINT = 13;

vec3 evaluate_car_paint(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_CAR_PAINT]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  vec3 sum = vec3(0.0);
  for (int lobe = 1; lobe < 10; lobe += 3)
    sum += p[lobe] * (beckmannDistribution(g, p[lobe + 1].x) * fresnel(g.cosD, p[lobe + 2].x, p[12].x, p[11].x));
  return p[0] / pi + sum * (vCavityOverCosines(g) / (p[10].x < 0.5 ? 4.0 : pi));
}
