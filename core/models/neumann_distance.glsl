// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// ks: k_s and all that does not depend on directions. sharpness: 1 / s^2.

INLINE REAL squaredDistance(SurfaceGeometry g) {
  REAL x = g.wi.x + g.wo.x, y = g.wi.y + g.wo.y;
  return x * x + y * y;
}

INLINE vec3 gaussianFalloff(SurfaceGeometry g, vec3 kd, vec3 ks, REAL sharpness) {
  return kd + ks * exp(-squaredDistance(g) * sharpness);
}
INLINE vec3 rationalFalloff(SurfaceGeometry g, vec3 kd, vec3 ks, REAL sharpness, REAL c) {
  return kd + ks * exp(-c * logOnePlus(squaredDistance(g) * sharpness));
}

// isRational: 1 or 0.
INLINE vec3 formula_neumann_distance(SurfaceGeometry g, vec3 kd, vec3 ks, REAL sharpness, REAL c, REAL isRational) {
  return isRational > 0.5 ? rationalFalloff(g, kd, ks, sharpness, c) : gaussianFalloff(g, kd, ks, sharpness);
}
