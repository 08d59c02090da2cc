// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
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
