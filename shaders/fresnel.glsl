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
