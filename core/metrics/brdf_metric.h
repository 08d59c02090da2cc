// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string_view>

namespace gonio::metrics {

/// The distances between two reflectances that the literature minimises or compares by. Each is a mean over the cells
/// that count (and their channels) of a power of d, the difference of the two after the metric's domain; weights are
/// the solid angles of each cell, times what the metric adds. The tenth of Lavoue's kind, the neural quality metric of
/// Kavoosighafi et al. 2025, is left out: it cannot be computed without the weights of its network.
enum class BrdfMetric {
  log,
  cosineL2,
  cubeRoot,
  meanAbsoluteLog,
  bieronPeersLog,
  gamma,
  logRelative,
  rms,
  cosineCubeRoot,
  projectedRms,
  meanAbsolute,
  cosinesCubeRoot,
  meanAbsoluteLogRelative,
  lab
};

/// What a reflectance is multiplied by before it is compared.
enum class MetricFactor {
  one,
  cosI,    ///< cos theta_i
  cosines  ///< max(cos theta_i cos theta_o, logRelativeOffset)
};
/// The function of the multiplied reflectance x whose difference d counts.
enum class MetricDomain {
  linear,       ///< x
  log,          ///< ln(1 + x)
  cubeRoot,     ///< x^(1/3)
  gamma,        ///< x^(1/g)
  logRelative,  ///< ln(x + logRelativeOffset)
  lab           ///< CIE 1976 L*a*b* of pi x as reflectance factors; the one domain that mixes the channels
};
enum class MetricPower { square, absolute, twoThirds };
/// What the solid angles of a cell are multiplied by.
enum class MetricWeight { one, cosO, cosines };

/// Floor of the cosines and of the reflectance under the logarithm (Nielsen et al. 2015).
inline constexpr double logRelativeOffset = 1e-3;
/// Of BrdfMetric::gamma where nothing else is said.
inline constexpr double defaultGamma = 2;
inline constexpr double smallestGamma = 1, largestGamma = 3;

/// Everything there is to know of one metric: programs compute by it, people read it.
struct MetricRecord {
  BrdfMetric metric;
  std::string_view id;       ///< in JSON, on the command line and in lists
  std::string_view alias;    ///< another name under which the literature has the same number, or ""
  std::string_view name;     ///< for people
  std::string_view formula;  ///< x = rho cos theta_i, d of the two materials; <> is the weighted mean
  std::string_view unit;     ///< of the error; "" for a plain number
  std::string_view reference;
  MetricFactor factor;
  MetricDomain domain;
  MetricPower power;
  MetricWeight weight = MetricWeight::one;
  bool isRoot = true;       ///< the square root of the mean
  bool minimisable = true;  ///< whether a fit can minimise it
};

/// In the order in which errors are listed everywhere; the first is the default of fits.
std::span<const MetricRecord> metricRecords();
const MetricRecord& metricRecord(BrdfMetric metric);
/// The metrics alone, in the same order.
std::span<const BrdfMetric> allBrdfMetrics();
/// Those that a fit can minimise: the first ones of allBrdfMetrics().
std::span<const BrdfMetric> minimisableMetrics();

/// MetricRecord::id.
std::string_view metricName(BrdfMetric metric);
/// By the id or the alias. @throws Error that lists the ids.
BrdfMetric metricByName(std::string_view name);

}  // namespace gonio::metrics
