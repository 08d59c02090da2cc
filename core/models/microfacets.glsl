// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#ifndef MICROFACETS_GLSL
#define MICROFACETS_GLSL

// Beckmann's distribution of facets, exp(-tan^2 theta_h / m^2) / (pi m^2 cos^4 theta_h), 1/sr: D cos theta_h integrates
// to 1 over the hemisphere (Beckmann and Spizzichino 1963; Cook and Torrance 1982 omit the 1/pi). inverseM2: 1 / m^2, m
// the root mean square slope.
INLINE REAL beckmannDistribution(SurfaceGeometry g, REAL inverseM2) {
  REAL cos2H = max(g.h.z * g.h.z, 1e-18);  // the exponential is 0 long before; its square stays in the range of float
  return exp(-g.sin2H / cos2H * inverseM2) * inverseM2 / (pi * cos2H * cos2H);
}

// G / (cos theta_i cos theta_o) of the V-cavity masking G = min(1, 2 cos theta_h cos theta_i / cos theta_d, 2 cos theta_h
// cos theta_o / cos theta_d) (Cook and Torrance, "A Reflectance Model for Computer Graphics", 1982), computed in a form in
// which the smaller cosine cancels where G is small.
INLINE REAL vCavityOverCosines(SurfaceGeometry g) {
  REAL unmasked = 1.0 / (g.cosI * g.cosO);
  REAL masked = 2.0 * g.h.z / (g.cosD * (g.cosI > g.cosO ? g.cosI : g.cosO));
  return unmasked < masked ? unmasked : masked;
}

#endif
