// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/models/fresnel.h. `contrast` is eta^2 - 1: formed by the callers below, where it does not cancel.
float fresnelOfContrast(float cosD, float contrast) {
  float c = clamp(cosD, 0.0, 1.0);
  float squaredG = contrast + c * c;
  if (squaredG < 0.0 || c == 0.0) return 1.0;
  float g = sqrt(squaredG);
  float sum = g + c;
  float difference = contrast / sum;
  float ratio = difference / sum;
  float polarised = (c * sum - 1.0) / (c * difference + 1.0);
  return min(1.0, 0.5 * ratio * ratio * (1.0 + polarised * polarised));
}

float fresnelDielectric(float cosD, float eta) {
  return eta == 1.0 ? 0.0 : fresnelOfContrast(cosD, (eta - 1.0) * (eta + 1.0));
}

float fresnelOfNormalReflectance(float cosD, float f0) {
  if (f0 >= 1.0) return 1.0;
  if (f0 <= 0.0) return 0.0;
  float root = sqrt(f0);
  float complement = (1.0 - f0) / (1.0 + root);  // 1 - root
  return fresnelOfContrast(cosD, 4.0 * root / (complement * complement));
}

float fresnelConductor(float cosD, float eta, float k) {
  float c = clamp(cosD, 0.0, 1.0), cos2 = c * c, sin2 = (1.0 - c) * (1.0 + c);
  float difference = (eta - k) * (eta + k) - sin2;
  float modulus = length(vec2(difference, 2.0 * eta * k));
  float root = 2.0 * c * sqrt(max(0.0, 0.5 * (modulus + difference)));
  float sum = modulus + cos2;
  if (!(sum + root > 0.0)) return 1.0;
  float perpendicular = max(0.0, sum - root) / (sum + root);
  float across = cos2 * modulus + sin2 * sin2, along = root * sin2;
  float ratio = across + along > 0.0 ? max(0.0, across - along) / (across + along) : 1.0;
  return min(1.0, 0.5 * perpendicular * (1.0 + ratio));
}

// Twin of the class Fresnel: `choice` 0 dielectric, 1 conductor, 2 Schlick.
float fresnel(float cosD, float f0, float edgeTint, float choice) {
  if (f0 >= 1.0) return 1.0;
  if (choice > 1.5) {
    float m = clamp(1.0 - cosD, 0.0, 1.0), m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
  }
  if (choice < 0.5 || edgeTint <= 0.0) return fresnelOfNormalReflectance(cosD, f0);
  float root = sqrt(f0);
  float eta = edgeTint * (1.0 - f0) / (1.0 + f0) + (1.0 - edgeTint) * (1.0 + root) / (1.0 - root);
  float k2 = ((eta + 1.0) * (eta + 1.0) * f0 - (eta - 1.0) * (eta - 1.0)) / (1.0 - f0);
  return fresnelConductor(cosD, eta, sqrt(max(0.0, k2)));
}
