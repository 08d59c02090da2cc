// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of spherical_harmonics.cpp, without its table of normalised polynomials.
const int harmonicBands = 5;

// Twin of core/math/special_functions.h for one order m: the polar parts of bands m..4.
void normalisedLegendre(int m, float diagonal, float z, out float q[harmonicBands]) {
  float before = 0.0, last = diagonal, lastFactor = 0.0;
  q[m] = diagonal;
  for (int l = m + 1; l < harmonicBands; ++l) {
    float factor = sqrt(float(4 * l * l - 1) / float(l * l - m * m));
    float next = factor * (z * last - (lastFactor > 0.0 ? before / lastFactor : 0.0));
    before = last;
    last = next;
    lastFactor = factor;
    q[l] = next;
  }
}

// coefficients: with their window, for m = 0..4, l = m..4, l' = m..l.
vec3 formula_spherical_harmonics(SurfaceGeometry g, vec3 coefficients[35]) {
  vec3 wi = g.wi, wo = g.wo;
  vec2 step = vec2(dot(wi.xy, wo.xy), wi.y * wo.x - wi.x * wo.y), power = vec2(1.0, 0.0);
  float diagonal = 0.5 * inversesqrt(pi);
  vec3 sum = vec3(0.0);
  int at = 0;
  float qi[harmonicBands], qo[harmonicBands];
  for (int m = 0; m < harmonicBands; ++m) {
    if (m > 0) diagonal *= sqrt(float(2 * m + 1) / float(2 * m));
    normalisedLegendre(m, diagonal, g.cosI, qi);
    normalisedLegendre(m, diagonal, g.cosO, qo);
    for (int high = m; high < harmonicBands; ++high)
      for (int low = m; low <= high; ++low)
        sum += coefficients[at++] * (power.x * (qi[high] * qo[low] + qi[low] * qo[high]));
    power = vec2(power.x * step.x - power.y * step.y, power.x * step.y + power.y * step.x);
  }
  return max(sum, vec3(0.0));
}
