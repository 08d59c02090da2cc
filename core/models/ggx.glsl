// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.glsl"

// correlated: 1 for height-correlated masking, 0 for separable.
INLINE void formula_ggx(SurfaceGeometry g, vec3 kd, vec3 ks, REAL alpha2, REAL correlated, FresnelTerm term,
                        OUT vec3 lobes[2]) {
  REAL slope = g.sin2H + alpha2 * g.h.z * g.h.z;
  REAL distribution = alpha2 / (pi * slope * slope);
  // G / (4 cos theta_i cos theta_o), folded so that nothing is divided by a cosine.
  REAL rootI = sqrt(alpha2 + (1.0 - alpha2) * g.cosI * g.cosI);
  REAL rootO = sqrt(alpha2 + (1.0 - alpha2) * g.cosO * g.cosO);
  REAL ofBoth = 2.0 * (g.cosO * rootI + g.cosI * rootO), separate = (g.cosI + rootI) * (g.cosO + rootO);
  REAL masking = 1.0 / (correlated * ofBoth + (1.0 - correlated) * separate);
  lobes[0] = kd;
  lobes[1] = ks * (distribution * fresnel(term, g.cosD) * masking);
}
