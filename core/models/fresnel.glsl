// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Fresnel terms. cosD: cosine of the angle to the (micro)facet normal, [0, 1].
#ifndef FRESNEL_GLSL
#define FRESNEL_GLSL

// Unpolarised reflectance of a dielectric with the relative index eta > 0, in the form of Cook and Torrance 1982. eta = 1
// gives 0; total reflection (eta < 1) and grazing incidence give 1.
INLINE REAL fresnelDielectric(REAL cosD, REAL eta) {
  REAL c = clamp(cosD, 0.0, 1.0);
  REAL contrast = (eta - 1.0) * (eta + 1.0);
  REAL squaredG = contrast + c * c, g = sqrt(max(squaredG, 0.0));
  REAL sum = g + c;
  REAL difference = contrast / sum;  // g - c without cancellation for an index near 1
  REAL ratio = difference / sum;
  REAL polarised = (c * sum - 1.0) / (c * difference + 1.0);
  REAL partial = min(1.0, 0.5 * ratio * ratio * (1.0 + polarised * polarised));
  REAL below = squaredG < 0.0 ? 1.0 : partial, value = cosD > 0.0 ? below : 1.0;
  REAL finite = eta > 1e18 ? 1.0 : value;
  return eta == 1.0 ? 0.0 : finite;
}

// The fraction transmitted into the dielectric, 1 - fresnelDielectric(cosD, eta), without cancellation toward grazing
// angles.
INLINE REAL fresnelTransmittance(REAL cosD, REAL eta) {
  REAL c = clamp(cosD, 0.0, 1.0);
  REAL squaredG = (eta - 1.0) * (eta + 1.0) + c * c;
  REAL g = sqrt(max(squaredG, 0.0));  // eta times the cosine inside
  REAL s = g + c, p = g / eta + c * eta;
  REAL partial = min(1.0, 2.0 * c * g * (1.0 / (s * s) + 1.0 / (p * p)));
  REAL limit = eta == 1.0 ? 1.0 : 0.0;
  REAL below = squaredG < 0.0 ? 0.0 : partial, value = cosD > 0.0 ? below : limit;
  return eta > 1e18 ? 0.0 : value;
}

// f0 + (1 - f0)(1 - cosD)^5: Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering".
INLINE REAL fresnelSchlick(REAL cosD, REAL f0) {
  REAL m = 1.0 - cosD, m2 = m * m;
  return f0 + (1.0 - f0) * (m2 * m2 * m);
}

// Unpolarised reflectance of a conductor with the complex index eta + i k (Born and Wolf, Principles of Optics, section
// 14.2). contrast: eta^2 - k^2 - 1, product: 2 eta k, which is 0 for a dielectric.
INLINE REAL fresnelOfContrast(REAL cosD, REAL contrast, REAL product) {
  REAL c = cosD, cos2 = c * c, sin2 = 1.0 - cos2;
  // (a + i b)^2 = index^2 - sin^2; the smaller of a^2 and b^2 by their product, where the difference would cancel.
  REAL difference = contrast + cos2, modulus = sqrt(difference * difference + product * product);
  REAL larger = 0.5 * (modulus + abs(difference));
  REAL quotient = 0.25 * product * product / larger, smaller = larger > 0.0 ? quotient : 0.0;
  REAL a2 = difference > 0.0 ? larger : smaller, b2 = difference > 0.0 ? smaller : larger;
  REAL a = sqrt(a2), sum = a + c;
  // a - c without cancellation for an index near 1.
  REAL excess = contrast + (contrast * (contrast + 2.0 * cos2) + product * product) / (modulus + cos2);
  REAL apart = excess / (2.0 * sum);
  REAL perpendicular = (apart * apart + b2) / (sum * sum + b2);
  REAL across = a * c - sin2, along = a * c + sin2;
  REAL ratio = (across * across + b2 * cos2) / (along * along + b2 * cos2);
  REAL partial = min(1.0, 0.5 * perpendicular * (1.0 + ratio));
  return sum > 0.0 ? partial : 1.0;  // total reflection, and index 1 at grazing angle: the limit of all others
}

// The term that a model's parameters select: sums with weights of 0 and 1 instead of branches.
struct FresnelTerm {
  REAL exactFraction, contrast, product;  // of fresnelOfContrast()
  REAL constant, risingFraction;          // constant + risingFraction (1 - cosD)^5
};

INLINE REAL fresnel(FresnelTerm term, REAL cosD) {
  REAL m = 1.0 - cosD, m2 = m * m;
  return term.exactFraction * fresnelOfContrast(cosD, term.contrast, term.product) + term.constant +
         term.risingFraction * (m2 * m2 * m);
}

#endif
