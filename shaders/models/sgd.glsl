// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, alpha, p, f0, f1, lambda, ln c, k, theta0, then ln K: c exceeds float, and K needs the
// incomplete gamma function.
#include "math.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_SGD = 11;

float sgdMasking(float theta, float lambda, float logC, float k, float theta0) {
  const float maxExponent = 80.0;  // exp() of it is finite in float
  float beyond = theta - theta0;
  if (!(beyond > 0.0)) return 1.0;
  float growth = exp(min(maxExponent, logC + k * log(beyond)));
  return clamp(1.0 - lambda * expMinusOne(min(maxExponent, growth)), 0.0, 1.0);
}

vec3 evaluate_sgd(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_SGD]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float cos2H = g.h.z * g.h.z;
  float thetaI = atan(length(wi.xy), wi.z);
  float thetaO = atan(length(wo.xy), wo.z);
  float logCosines = 2.0 * log(cos2H) + log(g.cosI) + log(g.cosO);
  float m = 1.0 - g.cosD;
  vec3 value = p[0] / pi;
  for (int c = 0; c < 3; ++c) {
    float shifted = p[2][c] + g.sin2H / (cos2H * p[2][c]);
    // All factors that leave float stand in one exponent; the cap (2.5e30) is reached in absurd corners only.
    float distribution = exp(min(70.0, p[10][c] - shifted - p[3][c] * log(shifted) - logCosines));
    float fresnel = max(0.0, p[4][c] - p[5][c] * g.cosD + (1.0 - p[4][c]) * m * m * m * m * m);
    float masking = sgdMasking(thetaI, p[6][c], p[7][c], p[8][c], p[9][c]) *
                    sgdMasking(thetaO, p[6][c], p[7][c], p[8][c], p[9][c]);
    value[c] += p[1][c] / (pi * pi) * fresnel * distribution * masking;
  }
  return value;
}
