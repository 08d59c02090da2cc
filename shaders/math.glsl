// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
const float pi = 3.14159265358979;

// ln(1 + x), x > -1, accurate near 0 (GLSL has no log1p).
float logOnePlus(float x) {
  if (abs(x) > 0.3) return log(1.0 + x);
  float s = x / (2.0 + x);
  float s2 = s * s;
  return 2.0 * s * (1.0 + s2 * (1.0 / 3.0 + s2 * (1.0 / 5.0 + s2 * (1.0 / 7.0 + s2 / 9.0))));
}

// exp(x) - 1, accurate near 0 (GLSL has no expm1).
float expMinusOne(float x) {
  if (abs(x) > 0.3) return exp(x) - 1.0;
  return x * (1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0 * (1.0 + x / 6.0 * (1.0 + x / 7.0))))));
}

// The angle of a sine and a cosine that are not negative (0 of two zeros), to a few units in the last place: drivers'
// atan() is coarser.
float acuteAngle(float sine, float cosine) {
  float sum = length(vec2(sine, cosine)) + cosine;
  float t = sum > 0.0 ? sine / sum : 0.0;  // of the half angle
  t = t / (1.0 + sqrt(1.0 + t * t));                       // of a quarter
  float t2 = t * t;
  return 4.0 * t *
         (1.0 - t2 * (1.0 / 3.0 - t2 * (1.0 / 5.0 - t2 * (1.0 / 7.0 - t2 * (1.0 / 9.0 - t2 * (1.0 / 11.0 - t2 / 13.0))))));
}

// 1 - erf(x), x >= 0, to 1.2e-7 relative: Press et al. 1992, Numerical Recipes in C, section 6.2.
float complementaryError(float x) {
  float t = 1.0 / (1.0 + 0.5 * x);
  float series = 0.17087277;
  series = -0.82215223 + t * series;
  series = 1.48851587 + t * series;
  series = -1.13520398 + t * series;
  series = 0.27886807 + t * series;
  series = -0.18628806 + t * series;
  series = 0.09678418 + t * series;
  series = 0.37409196 + t * series;
  series = 1.00002368 + t * series;
  return t * exp(-x * x - 1.26551223 + t * series);
}
