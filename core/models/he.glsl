// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of he.cpp and he_series.h: the same series, summed in another order for single precision.
#include "core/models/fresnel.glsl"

// (1 + u) ln(1 + u) - u, accurate near 0.
float heExcess(float u) {
  if (abs(u) > 0.15) return (1.0 + u) * log(1.0 + u) - u;
  return u * u * (1.0 / 2.0 - u * (1.0 / 6.0 - u * (1.0 / 12.0 - u * (1.0 / 20.0 - u * (1.0 / 30.0 - u * (1.0 / 42.0 - u / 56.0))))));
}

float heLogTerm(float g, float a, float m) {
  return -g * heExcess((m - g) / g) - 0.5 * log(2.0 * pi * m) - 1.0 / (12.0 * m) + 1.0 / (360.0 * m * m * m) - log(m) - a / m;
}
float heLargestOrder(float g, float a) {
  float m = max(1.0, max(g, sqrt(a)));
  for (int n = 0; n < 8; ++n) {
    float slope = log(g / (m + 0.5)) - 1.0 / m + a / (m * m);
    float curvature = 1.0 / (m + 0.5) - 1.0 / (m * m) + 2.0 * a / (m * m) / m;
    m = max(1.0, m * exp(clamp(slope / (m * max(curvature, 0.3 / m)), -1.0, 1.0)));
  }
  return m;
}
float heSeries(float g, float a) {
  float order = heLargestOrder(g, a), sum = 0.0;
  if (order <= 25.0) {
    float power = exp(-g);
    for (int m = 1; m <= 100; ++m) {
      power *= g / float(m);
      float term = power / float(m) * exp(-a / float(m));
      sum += term;
      if (float(m) > order && term <= 1e-9 * sum) break;
    }
    return sum;
  }
  float width = inversesqrt(1.0 / (order + 0.5) - 1.0 / (order * order) + 2.0 * a / (order * order) / order);
  float spacing = 0.5 * width;
  for (int n = -14; n <= 14; ++n) {
    float m = order + float(n) * spacing;
    if (m >= 1.0) sum += exp(heLogTerm(g, a, m));
  }
  return sum * spacing;
}
float heVisibleRoughness(float c) {
  if (!(c > 1e-8)) return 1.0;
  float right = 2.0 * log(c);
  float y = right > 1.0 ? log(right) : right;
  for (int n = 0; n < 8; ++n) {
    float square = exp(y);
    y -= (y + square - right) / (1.0 + square);
  }
  return 1.0 / (1.0 + exp(y));
}

// S / cos theta and K.
vec2 heShadowing(vec3 w, float slope) {
  float sine = length(w.xy), x = w.z / (2.0 * slope * sine);
  if (!(x < 9.0)) return vec2(1.0 / w.z, 0.0);
  float hidden = complementaryError(x), seen = 1.0 - 0.5 * hidden;
  return vec2(seen / (seen * w.z + exp(-x * x) * sine * slope / sqrt(pi)), sine / w.z * hidden);
}

vec3 formula_he(SurfaceGeometry g, vec3 kd, vec3 ks, float sigma, float tau, FresnelTerm term) {
  float slope = sigma / tau;
  vec2 i = heShadowing(g.wi, slope), o = heShadowing(g.wo, slope);
  float height = 2.0 * pi * sigma * (g.cosI + g.cosO), size = 2.0 * pi * tau * g.cosD;
  float phase = height * height * heVisibleRoughness((i.y + o.y) / sqrt(8.0 * pi));
  float tilt = size * size * g.sin2H, ratio = g.cosD / g.h.z;
  float factor = pi * tau * tau * fresnel(term, g.cosD) * i.x * o.x;
  vec3 wavelengths = vec3(0.6114, 0.5491, 0.4643), lobe;
  for (int channel = 0; channel < 3; ++channel) {
    float wave = 1.0 / (wavelengths[channel] * wavelengths[channel]);
    // The series first: it is 0 where the quotient leaves the range of float.
    lobe[channel] = wave * heSeries(phase * wave, tilt * wave) * ratio * ratio;
  }
  return kd + ks * lobe * factor;
}
