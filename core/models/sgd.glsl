// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of sgd.cpp. Single precision needs another order of the factors: those that leave float stand in one exponent.

float sgdMasking(float theta, float lambda, float logC, float k, float theta0) {
  const float maxExponent = 80.0;  // exp() of it is finite in float
  float beyond = theta - theta0;
  if (!(beyond > 0.0)) return 1.0;
  float growth = exp(min(maxExponent, logC + k * log(beyond)));
  return clamp(1.0 - lambda * expMinusOne(min(maxExponent, growth)), 0.0, 1.0);
}

// logK: ln K, which needs the incomplete gamma function. logC: ln c, because c exceeds float.
vec3 formula_sgd(SurfaceGeometry g, vec3 diffuse, vec3 specular, vec3 alpha, vec3 p, vec3 f0, vec3 f1, vec3 lambda, vec3 logC,
                 vec3 k, vec3 theta0, vec3 logK) {
  float cos2H = g.h.z * g.h.z;
  float thetaI = atan(length(g.wi.xy), g.wi.z);
  float thetaO = atan(length(g.wo.xy), g.wo.z);
  float logCosines = 2.0 * log(cos2H) + log(g.cosI) + log(g.cosO);
  float m = 1.0 - g.cosD;
  vec3 value = diffuse / pi;
  for (int c = 0; c < 3; ++c) {
    float shifted = alpha[c] + g.sin2H / (cos2H * alpha[c]);
    // The cap (2.5e30) is reached in absurd corners only.
    float distribution = exp(min(70.0, logK[c] - shifted - p[c] * log(shifted) - logCosines));
    float fresnel = max(0.0, f0[c] - f1[c] * g.cosD + (1.0 - f0[c]) * m * m * m * m * m);
    float masking = sgdMasking(thetaI, lambda[c], logC[c], k[c], theta0[c]) *
                    sgdMasking(thetaO, lambda[c], logC[c], k[c], theta0[c]);
    value[c] += specular[c] / (pi * pi) * fresnel * distribution * masking;
  }
  return value;
}
