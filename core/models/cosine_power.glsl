// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Powers of the cosine of the angle between light and mirror direction (Phong), or between half vector and normal
// (Blinn). Near 1 the cosine is computed from the distance between the directions, so that exponents of a million are
// accurate.
#ifndef COSINE_POWER_GLSL
#define COSINE_POWER_GLSL

// (1 - x)^n for x >= 0; 0 beyond 1.
INLINE REAL powerOfComplement(REAL x, REAL n) { return x < 1.0 ? exp(n * logOnePlus(-x)) : 0.0; }

// max(0, cos alpha)^n, alpha the angle between wi and the mirror direction of wo.
INLINE REAL reflectionPower(SurfaceGeometry g, REAL n) {
  vec3 apart = vec3(g.wi.x + g.wo.x, g.wi.y + g.wo.y, g.wi.z - g.wo.z);
  return powerOfComplement(0.5 * dot(apart, apart), n);
}

// cos^n theta_h; also accurate for nearly horizontal half vectors.
INLINE REAL halfVectorPower(SurfaceGeometry g, REAL n) { return exp(n * logCosH(g)); }

#endif
