// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// exp(kappa cos^gamma theta_h) - 1. logKappa, logGamma: coefficients of the polynomials of t.
INLINE REAL dsbrdfLobe(REAL logCosH, REAL t, vec3 logKappa, vec2 logGamma) {
  // Beyond 40, float does not resolve exp(kappa).
  REAL kappa = min(40.0, exp(logKappa.x + t * (logKappa.y + t * logKappa.z)));
  return expMinusOne(kappa * exp(exp(logGamma.x + t * logGamma.y) * logCosH));
}

// s1, s2: strength / (exp(kappa(0)) - 1).
INLINE vec3 formula_dsbrdf(SurfaceGeometry g, vec3 kd, vec3 s1, vec3 logKappa1, vec2 logGamma1, vec3 s2, vec3 logKappa2,
                           vec2 logGamma2) {
  REAL logCosine = logOnePlus(-g.oneMinusCosH);
  // theta_d as a fraction of 90 degrees, by its sine too: acos loses half the digits near 1.
  REAL t = acuteAngle(0.5 * length(g.wi - g.wo), g.cosD) / (0.5 * pi);
  vec3 lobes = s1 * dsbrdfLobe(logCosine, t, logKappa1, logGamma1) + s2 * dsbrdfLobe(logCosine, t, logKappa2, logGamma2);
  return kd + lobes;
}
