// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, then for each of two lobes strength / (exp(kappa(0)) - 1), the coefficients of ln kappa and of ln gamma as
// polynomials of theta_d / 90 degrees
#include "math.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_DSBRDF = 7;

float dsbrdfLobe(vec3 logKappa, vec3 logGamma, float logCosH, float t) {
  float kappa = min(40.0, exp(logKappa.x + t * (logKappa.y + t * logKappa.z)));
  return expMinusOne(kappa * exp(exp(logGamma.x + t * logGamma.y) * logCosH));
}

vec3 evaluate_dsbrdf(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_DSBRDF]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float logCosH = logOnePlus(-g.oneMinusCosH);
  // theta_d by its sine too: acos loses half the digits near 1.
  float t = atan(0.5 * length(wi - wo), g.cosD) / (0.5 * pi);
  return p[0] / pi + p[1] * dsbrdfLobe(p[2], p[3], logCosH, t) + p[4] * dsbrdfLobe(p[5], p[6], logCosH, t);
}
