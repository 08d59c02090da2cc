// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness x, roughness y, rotation, f0, masking (0 separable, 1 height-correlated), fresnel, edge
//    tint; behind them the cosine and sine of the rotation
#include "math.glsl"
#include "anisotropic_ggx.glsl"
#include "fresnel.glsl"
#include "grain.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_GGX_ANISOTROPIC = 10;

// The terms of the sum: the diffuse term, then the highlight.
const int LOBE_COUNT_GGX_ANISOTROPIC = 2;
void lobes_ggx_anisotropic(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_GGX_ANISOTROPIC], out vec3 lobes[LOBE_COUNT_GGX_ANISOTROPIC]) {
  SurfaceGeometry g;
  lobes[0] = lobes[1] = vec3(0.0);
  if (!surfaceGeometry(wi, wo, g)) return;
  vec2 alpha = vec2(p[2].x, p[3].x), axis = p[9].xy;
  float shadowedI = ggxCosineOverG1(inGrain(wi, axis), alpha);
  float shadowedO = ggxCosineOverG1(inGrain(wo, axis), alpha);
  float cosines = p[6].x < 0.5 ? shadowedI * shadowedO : g.cosO * shadowedI + g.cosI * shadowedO - g.cosI * g.cosO;
  lobes[0] = p[0] / pi;
  lobes[1] = p[1] * (ggxDensity(inGrain(g.h, axis), alpha) * fresnel(g.cosD, p[5].x, p[8].x, p[7].x) / (4.0 * cosines));
}

vec3 evaluate_ggx_anisotropic(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_GGX_ANISOTROPIC]) {
  vec3 lobes[LOBE_COUNT_GGX_ANISOTROPIC];
  lobes_ggx_anisotropic(wi, wo, p, lobes);
  return lobes[0] + lobes[1];
}
