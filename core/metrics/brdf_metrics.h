// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"

namespace gonio::metrics {

/// A distance between two reflectances over cells: E = sqrt(sum w d^2 / sum w) over cells and channels, with d the
/// difference of the two after the metric's transform and w the metric's weight. 0 for equal values.
enum class BrdfMetric {
  log,             ///< Loew et al. 2012: d of log(1 + rho cos theta_i) (the default of fits)
  cosineL2,        ///< Ngan et al. 2005: d of rho cos theta_i
  cubeRoot,        ///< d of (rho cos theta_i)^(1/3): Bieron and Peers 2020 with gamma 3
  meanAbsoluteLog  ///< Sztrajman et al. 2021: mean of |d of log(1 + rho cos theta_i)|
};
std::span<const BrdfMetric> allBrdfMetrics();
/// Name in JSON, on the command line and in lists: "log", "cosine-l2", "cube-root", "mean-absolute-log".
std::string_view metricName(BrdfMetric metric);
/// @throws Error that lists the names.
BrdfMetric metricByName(std::string_view name);

/// Which cells count: valid in both, both polar angles at most `maxPolarAngle` (rad); weight = cell measure.
inline constexpr double defaultMaxPolarAngle = 85 * 3.14159265358979323846 / 180;

/// @param test evaluated at the nodes of the reference's grid. In parallel, deterministic.
double brdfError(BrdfMetric metric, const TabulatedBrdf& reference, const Brdf& test,
                 double maxPolarAngle = defaultMaxPolarAngle);
/// All metrics in one pass, in the order of allBrdfMetrics().
std::vector<double> brdfErrors(const TabulatedBrdf& reference, const Brdf& test,
                               double maxPolarAngle = defaultMaxPolarAngle);

/// 10 log10(sum |r|^2 / sum |r - t|^2) with r = rho cos theta_i cos theta_o over the reference's valid cells, dB.
/// Contract for 0 as signalToNoiseRatio of pictures.
double brdfSignalToNoiseRatio(const TabulatedBrdf& reference, const Brdf& test);

}  // namespace gonio::metrics
