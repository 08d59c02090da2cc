// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/metrics/brdf_metric.h"

namespace gonio::metrics {

/// Default of `maxPolarAngle`, rad. Metrics use the cells that are valid in the reference, and in the test if it is a
/// table, with both polar angles up to this limit, weighted by HalfDifferenceGrid::cellMeasure().
inline constexpr double defaultMaxPolarAngle = 85 * 3.14159265358979323846 / 180;

/// The error <|d|^p> or its square root, as MetricRecord defines; 0 for equal values and if no cell is used. Negative
/// BRDF values count as 0. Parallel, deterministic.
/// @param test evaluated at the nodes of the reference's grid.
/// @param gamma g of BrdfMetric::gamma: values are raised to 1/g.
double brdfError(BrdfMetric metric, const TabulatedBrdf& reference, const Brdf& test,
                 double maxPolarAngle = defaultMaxPolarAngle, double gamma = defaultGamma);
/// All metrics in one pass, in the order of allBrdfMetrics(). About 0.2 s for a MERL table and a fast `test`.
std::vector<double> brdfErrors(const TabulatedBrdf& reference, const Brdf& test,
                               double maxPolarAngle = defaultMaxPolarAngle, double gamma = defaultGamma);

/// All metrics over pairs of directions at or above the horizon, for materials without a half-difference table.
/// @param values of the reference, 1/sr. @param measures weights of the pairs, not normalised.
std::vector<double> brdfErrors(std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                               std::span<const double> measures, const Brdf& test, double gamma = defaultGamma);

/// BRDF SNR, dB: 10 log10(sum |r|^2 / sum |r - t|^2) with r, t = rho cos theta_i cos theta_o of reference and test,
/// over the reference's valid cells. Special cases as decibels().
double brdfSignalToNoiseRatio(const TabulatedBrdf& reference, const Brdf& test);

}  // namespace gonio::metrics
