// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"

/// Whether directions are drawn from the density that a BRDF states.
namespace gonio::test {

/// A direction 2 % further from the mirror direction; the same one where that would be below the horizon.
Direction widened(const Direction& wi, const Direction& wo);

/// The probability that Pearson's chi-squared is as large as found, were counts of draws by chance about what is
/// expected; cells next to each other are pooled until ten are expected.
double pearsonPValue(const std::vector<double>& expected, const std::vector<double>& observed);

struct SamplingCheck {
  double integral = 0;     ///< of the density over the hemisphere: 1 - lost
  double lost = 0;         ///< fraction of the draws that have the density 0
  double pValue = 1;       ///< of Pearson's chi-squared test of the draws against the integrals of the cells
  double widerPValue = 1;  ///< of the same draws, each 2 % further from the mirror direction: what a test has to find
  bool valid = true;       ///< every other draw is a unit vector above the horizon with the positive density of pdf()
};
/// @param draws of the test; more find smaller errors. @param tolerance of the integral over a cell.
SamplingCheck checkSampling(const Brdf& brdf, const Direction& wo, int draws = 1 << 15, double tolerance = 5e-7);

}  // namespace gonio::test
