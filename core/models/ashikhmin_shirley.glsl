// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/cosine_power.glsl"
#include "core/models/fresnel.glsl"

INLINE REAL enteringFraction(REAL cosine) {
  REAL m = 1.0 - 0.5 * cosine, m2 = m * m;
  return 1.0 - m2 * m2 * m;
}

// kd, ks: with all that does not depend on directions. coupled: 1, or 0 for Lambert's diffuse term. exponents: n_x, n_y.
// axis: cosine and sine of the rotation.
INLINE void formula_ashikhmin_shirley(SurfaceGeometry g, vec3 kd, vec3 ks, REAL coupled, vec2 exponents, vec2 axis,
                                      FresnelTerm term, OUT vec3 lobes[2]) {
  vec3 h = inGrain(g.h, axis);
  REAL slopes = exponents.x * h.x * h.x + exponents.y * h.y * h.y;
  REAL power = halfVectorPower(g, g.sin2H > 0.0 ? slopes / g.sin2H : 0.0);
  REAL lobe = power * fresnel(term, g.cosD) / (g.cosD * max(g.cosI, g.cosO));
  lobes[0] = (coupled * (enteringFraction(g.cosI) * enteringFraction(g.cosO)) + (1.0 - coupled)) * kd;
  lobes[1] = ks * lobe;
}
