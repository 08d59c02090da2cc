// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, roughness x, roughness y, rotation, f0, masking (0 separable, 1 height-correlated), fresnel, edge
//    tint; behind them the cosine and sine of the rotation
#include "complementary_error.glsl"
#include "math.glsl"
#include "fresnel.glsl"
#include "grain.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_BECKMANN_ANISOTROPIC = 10;

// Twins of core/sampling/half_vector_densities.h.
float beckmannDensity(vec3 h, vec2 alpha) {
  vec2 slope = h.xy / (alpha * h.z);
  // cos^4 leaves float toward the horizon: it goes into the exponent.
  return exp(-dot(slope, slope) - 4.0 * log(h.z)) / (pi * alpha.x * alpha.y);
}
float beckmannCosineOverG1(vec3 w, vec2 alpha) {
  float slope = length(alpha * w.xy);
  // Beyond, no facet is masked that float would notice.
  const float open = 9.0;
  if (w.z >= open * slope) return w.z;
  float a = w.z / slope;
  return w.z * (1.0 - 0.5 * complementaryError(a)) + slope * exp(-a * a) / (2.0 * sqrt(pi));
}

// The terms of the sum: the diffuse term, then the highlight.
const int LOBE_COUNT_BECKMANN_ANISOTROPIC = 2;
void lobes_beckmann_anisotropic(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_BECKMANN_ANISOTROPIC], out vec3 lobes[LOBE_COUNT_BECKMANN_ANISOTROPIC]) {
  SurfaceGeometry g;
  lobes[0] = lobes[1] = vec3(0.0);
  if (!surfaceGeometry(wi, wo, g)) return;
  vec2 alpha = vec2(p[2].x, p[3].x), axis = p[9].xy;
  float shadowedI = beckmannCosineOverG1(inGrain(wi, axis), alpha);
  float shadowedO = beckmannCosineOverG1(inGrain(wo, axis), alpha);
  float cosines = p[6].x < 0.5 ? shadowedI * shadowedO : g.cosO * shadowedI + g.cosI * shadowedO - g.cosI * g.cosO;
  lobes[0] = p[0] / pi;
  lobes[1] = p[1] * (beckmannDensity(inGrain(g.h, axis), alpha) * fresnel(g.cosD, p[5].x, p[8].x, p[7].x) / (4.0 * cosines));
}

vec3 evaluate_beckmann_anisotropic(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_BECKMANN_ANISOTROPIC]) {
  vec3 lobes[LOBE_COUNT_BECKMANN_ANISOTROPIC];
  lobes_beckmann_anisotropic(wi, wo, p, lobes);
  return lobes[0] + lobes[1];
}
