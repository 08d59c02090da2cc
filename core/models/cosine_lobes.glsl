// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// The lobes of Phong and Blinn. ks: k_s N, n: the exponent.
#include "core/models/cosine_power.glsl"

INLINE vec3 formula_phong(SurfaceGeometry g, vec3 kd, vec3 ks, REAL n) { return kd + ks * reflectionPower(g, n); }
INLINE vec3 formula_modified_phong(SurfaceGeometry g, vec3 kd, vec3 ks, REAL n) { return formula_phong(g, kd, ks, n); }
INLINE vec3 formula_blinn_phong(SurfaceGeometry g, vec3 kd, vec3 ks, REAL n) { return kd + ks * halfVectorPower(g, n); }

// aboutHalfVector: 1 or 0.
INLINE vec3 formula_lewis(SurfaceGeometry g, vec3 kd, vec3 ks, REAL n, REAL aboutHalfVector) {
  return aboutHalfVector > 0.5 ? formula_blinn_phong(g, kd, ks, n) : formula_phong(g, kd, ks, n);
}

INLINE vec3 formula_neumann_phong(SurfaceGeometry g, vec3 kd, vec3 ks, REAL n) {
  return kd + ks * (reflectionPower(g, n) / max(g.cosI, g.cosO));
}
INLINE vec3 formula_neumann_blinn(SurfaceGeometry g, vec3 kd, vec3 ks, REAL n) {
  return kd + ks * (halfVectorPower(g, n) / max(g.cosI, g.cosO));
}
