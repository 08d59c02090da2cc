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

float fresnelTransmittance(float cosD, float eta) {
  float c = clamp(cosD, 0.0, 1.0), squaredG = (eta - 1.0) * (eta + 1.0) + c * c;
  if (squaredG < 0.0 || c == 0.0) return eta == 1.0 ? 1.0 : 0.0;
  float g = sqrt(squaredG);
  float s = g + c, p = g / eta + c * eta;
  return min(1.0, 2.0 * c * g * (1.0 / (s * s) + 1.0 / (p * p)));
}

float fresnelOfNormalReflectance(float cosD, float f0) {
  if (f0 >= 1.0) return 1.0;
  if (f0 <= 0.0) return 0.0;
  float root = sqrt(f0);
  float complement = (1.0 - f0) / (1.0 + root);  // 1 - root
  return fresnelOfContrast(cosD, 4.0 * root / (complement * complement));
}

// Of the index eta + i k: `contrast` is eta^2 - k^2 - 1, `product` 2 eta k.
float fresnelConductorOfContrast(float cosD, float contrast, float product) {
  float c = clamp(cosD, 0.0, 1.0), cos2 = c * c, sin2 = (1.0 - c) * (1.0 + c);
  float difference = contrast + cos2, modulus = length(vec2(difference, product));
  float larger = 0.5 * (modulus + abs(difference));
  float smaller = larger > 0.0 ? 0.5 * product * (0.5 * product / larger) : 0.0;
  float a = sqrt(difference > 0.0 ? larger : smaller), b2 = difference > 0.0 ? smaller : larger;
  float sum = a + c;
  if (!(sum > 0.0)) return 1.0;
  float apart = (contrast + (contrast * (contrast + 2.0 * cos2) + product * product) / (modulus + cos2)) / (2.0 * sum);
  float perpendicular = (apart * apart + b2) / (sum * sum + b2);
  float across = a * c - sin2, along = a * c + sin2;
  float ratio = (across * across + b2 * cos2) / (along * along + b2 * cos2);
  return min(1.0, 0.5 * perpendicular * (1.0 + ratio));
}

// Twin of the class Fresnel: `choice` 0 dielectric, 1 conductor, 2 Schlick.
float fresnel(float cosD, float f0, float edgeTint, float choice) {
  if (f0 >= 1.0) return 1.0;
  if (choice > 1.5) {
    float m = clamp(1.0 - cosD, 0.0, 1.0), m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
  }
  if (choice < 0.5 || edgeTint <= 0.0 || f0 <= 0.0) return fresnelOfNormalReflectance(cosD, f0);
  float root = sqrt(f0), g = edgeTint, complement = (1.0 - f0) / (1.0 + root);  // 1 - root
  float below = g * 2.0 * root * (1.0 + root) / (complement * (1.0 + f0));
  float above = (1.0 - g) * 4.0 * root / (1.0 - f0) + g * 2.0 * root * complement / ((1.0 + f0) * (1.0 + root));
  float etaMinusOne = 2.0 * root * ((1.0 - g) / complement - g * root / (1.0 + f0));
  float k2 = below * above;
  return fresnelConductorOfContrast(cosD, etaMinusOne * (etaMinusOne + 2.0) - k2, 2.0 * (etaMinusOne + 1.0) * sqrt(k2));
}
