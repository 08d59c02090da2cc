// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.glsl"
#include "core/models/microfacets.glsl"

// Shadowing and obscuration; at Omega = 0 its limit.
INLINE REAL obscuration(SurfaceGeometry g, REAL inverseTau, REAL omega) {
  REAL thetaH = acuteAngle(sqrt(g.sin2H), g.h.z);
  REAL thetaD = acuteAngle(0.5 * length(g.wi - g.wo), g.cosD);
  REAL shadowed = exp(-2.0 * thetaD * inverseTau), sum = omega + thetaH;
  return sum > 0.0 ? (omega + thetaH * shadowed) / sum : shadowed;
}

// kv: 2 k_v / pi, ks: k_s / 4.
INLINE vec3 formula_beard_maxwell(SurfaceGeometry g, vec3 kd, vec3 kv, vec3 ks, REAL inverseM2, REAL inverseTau,
                                  REAL omega, FresnelTerm term) {
  REAL surface = beckmannDistribution(g, inverseM2) * fresnel(term, g.cosD) * obscuration(g, inverseTau, omega) /
                 (g.cosI * g.cosO);
  return kd + kv / (g.cosI + g.cosO) + ks * surface;
}
