// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/metrics/brdf_metric.h"

namespace gonio::metrics {

/// Which cells count: valid in both, both polar angles at most `maxPolarAngle` (rad); weight = cell measure.
inline constexpr double defaultMaxPolarAngle = 85 * 3.14159265358979323846 / 180;

/// E = <|d|^p> or its square root, as the metric's record says; 0 for equal values and where no cell counts. Negative
/// reflectances count as 0.
/// @param test evaluated at the nodes of the reference's grid. In parallel, deterministic.
/// @param gamma of BrdfMetric::gamma alone.
double brdfError(BrdfMetric metric, const TabulatedBrdf& reference, const Brdf& test,
                 double maxPolarAngle = defaultMaxPolarAngle, double gamma = defaultGamma);
/// All metrics in one pass, in the order of allBrdfMetrics(). Some 0.2 s for a MERL table and a cheap test.
std::vector<double> brdfErrors(const TabulatedBrdf& reference, const Brdf& test,
                               double maxPolarAngle = defaultMaxPolarAngle, double gamma = defaultGamma);

/// All metrics over pairs of directions at or above the horizon, of materials that no half-difference table holds.
/// @param values of the reference, 1/sr; @param measures weights of the pairs, of any scale.
std::vector<double> brdfErrors(std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                               std::span<const double> measures, const Brdf& test, double gamma = defaultGamma);

/// 10 log10(sum |r|^2 / sum |r - t|^2) with r = rho cos theta_i cos theta_o over the reference's valid cells, dB.
/// Contract for 0 as signalToNoiseRatio of pictures.
double brdfSignalToNoiseRatio(const TabulatedBrdf& reference, const Brdf& test);

}  // namespace gonio::metrics
