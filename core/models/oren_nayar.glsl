// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// kd: A k_d / pi, rise: B k_d / pi.
INLINE vec3 formula_oren_nayar(SurfaceGeometry g, vec3 kd, vec3 rise) {
  // cos(phi) sin(max) tan(min) without angles: sin theta_i sin theta_o cos(phi) is the product of the projections.
  REAL across = max(0.0, g.wi.x * g.wo.x + g.wi.y * g.wo.y) / max(g.cosI, g.cosO);
  return kd + rise * across;
}
