// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.glsl"
#include "core/models/microfacets.glsl"

// (1 + B x)^-C, x >= 0; finite for large B.
INLINE REAL abcLobe(REAL x, REAL b, REAL c) { return exp(-c * logOnePlus(b * x)); }

// a: A / N.
INLINE vec3 formula_abc(SurfaceGeometry g, vec3 kd, vec3 a, REAL b, REAL c, FresnelTerm term) {
  REAL lobe = abcLobe(g.oneMinusCosH, b, c) * fresnel(term, g.cosD) * vCavityOverCosines(g);
  return kd + a * lobe;
}

// tiltFraction: 0 for the exact angle of the Fresnel term, 1/2 for that of the projected directions.
INLINE vec3 formula_abc_smooth(SurfaceGeometry g, vec3 kd, vec3 a, REAL b, REAL c, FresnelTerm term, REAL tiltFraction) {
  vec2 sum = vec2(g.wi.x + g.wo.x, g.wi.y + g.wo.y);
  // 1 - |i_p - o_p|^2 / 4 is cos^2 theta_d and this; the difference would cancel toward grazing mirror pairs.
  REAL tilt = tiltFraction * (g.cosI - g.cosO), cosD = min(1.0, sqrt(g.cosD * g.cosD + tilt * tilt));
  REAL lobe = abcLobe(dot(sum, sum), b, c) * fresnel(term, cosD);
  return kd + a * lobe;
}
