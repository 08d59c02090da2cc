// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.glsl"

// Twins of core/sampling/half_vector_densities.h; x runs along the grain. Those of GGX are in shaders/anisotropic_ggx.glsl.
#ifdef GLSL
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
#endif

// cos theta_i cos theta_o / G, so that nothing is divided by a cosine. shadowedI, shadowedO: each cosine over its G1.
INLINE REAL cosinesOverMasking(SurfaceGeometry g, REAL shadowedI, REAL shadowedO, REAL correlated) {
  REAL ofBoth = g.cosO * shadowedI + g.cosI * shadowedO - g.cosI * g.cosO;
  return correlated * ofBoth + (1.0 - correlated) * (shadowedI * shadowedO);
}

// ks: k_s / 4. alpha: along and across the grain. axis: cosine and sine of its rotation. correlated: 1 for
// height-correlated masking, 0 for separable.
INLINE void formula_ggx_anisotropic(SurfaceGeometry g, vec3 kd, vec3 ks, vec2 alpha, vec2 axis, REAL correlated,
                                    FresnelTerm term, OUT vec3 lobes[2]) {
  REAL shadowedI = ggxCosineOverG1(inGrain(g.wi, axis), alpha), shadowedO = ggxCosineOverG1(inGrain(g.wo, axis), alpha);
  REAL cosines = cosinesOverMasking(g, shadowedI, shadowedO, correlated);
  lobes[0] = kd;
  lobes[1] = ks * (ggxDensity(inGrain(g.h, axis), alpha) * fresnel(term, g.cosD) / cosines);
}

INLINE void formula_beckmann_anisotropic(SurfaceGeometry g, vec3 kd, vec3 ks, vec2 alpha, vec2 axis, REAL correlated,
                                         FresnelTerm term, OUT vec3 lobes[2]) {
  REAL shadowedI = beckmannCosineOverG1(inGrain(g.wi, axis), alpha);
  REAL shadowedO = beckmannCosineOverG1(inGrain(g.wo, axis), alpha);
  REAL cosines = cosinesOverMasking(g, shadowedI, shadowedO, correlated);
  lobes[0] = kd;
  lobes[1] = ks * (beckmannDensity(inGrain(g.h, axis), alpha) * fresnel(term, g.cosD) / cosines);
}
