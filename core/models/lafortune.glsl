// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/cosine_power.glsl"

// The generalised cosine over its largest factor is 1 - x: x is formed from differences, since it decides at large
// exponents. a, b: |C_xy| and C_z over the larger of them. side: -1 for positive C_xy (a lobe back towards the light), else
// 1.
INLINE REAL complementOfCosine(SurfaceGeometry g, REAL a, REAL b, REAL side) {
  REAL dx = g.wi.x + side * g.wo.x, dy = g.wi.y + side * g.wo.y, dz = g.wi.z - g.wo.z;
  REAL upright = g.wi.z * g.wi.z + g.wo.z * g.wo.z;
  REAL level = g.wi.x * g.wi.x + g.wi.y * g.wi.y + (g.wo.x * g.wo.x + g.wo.y * g.wo.y);
  REAL lean = a > b ? (a - b) * upright : (b - a) * level;
  return 0.5 * (a * (dx * dx + dy * dy) + b * dz * dz + lean);
}

INLINE vec3 formula_lafortune(SurfaceGeometry g, vec3 kd, vec3 ks, REAL a, REAL b, REAL side, REAL n) {
  return kd + ks * powerOfComplement(complementOfCosine(g, a, b, side), n);
}
