// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "core/brdf/data_transform.h"
#include "core/math/fast_functions.h"
#include "core/math/types.h"

namespace gonio::metrics {

/// Error metrics of BRDF values from the literature. Each is a mean of |d|^p over the used cells and channels, with d
/// the difference of two values in the metric's domain, weighted by the solid angles of each cell times the metric's
/// own weight. metricRecords() contains the definition of each (formula, unit, source); docs/command-line.md lists
/// them. Not included: the neural quality metric of Kavoosighafi et al. 2025, which requires the weights of its
/// network.
enum class BrdfMetric {
  log,                      ///< sqrt mean(d^2), d: difference of ln(1 + rho cos theta_i)
  cosineL2,                 ///< sqrt mean(d^2), d: difference of rho cos theta_i
  cubeRoot,                 ///< sqrt mean(d^2), d: difference of (rho cos theta_i)^(1/3)
  meanAbsoluteLog,          ///< mean(|d|), d as for `log`
  bieronPeersLog,           ///< sqrt mean(d^2 cos theta_o), d as for `log`
  gamma,                    ///< sqrt mean(d^2), d: difference of (rho cos theta_i)^(1/g)
  logRelative,              ///< sqrt mean(d^2), d: difference of ln(rho c + e), c = max(cos theta_i cos theta_o, e),
                            ///< e = logRelativeOffset
  rms,                      ///< sqrt mean(d^2), d: difference of rho
  cosineCubeRoot,           ///< sqrt mean(|d|^(2/3)), d as for `cosineL2`
  projectedRms,             ///< sqrt mean(d^2 cos theta_o), d as for `rms`
  meanAbsolute,             ///< mean(|d|), d as for `rms`
  cosinesCubeRoot,          ///< mean(|d|^(2/3)), d: difference of rho c, c as for `logRelative`
  meanAbsoluteLogRelative,  ///< mean(|d|), d as for `logRelative`
  lab                       ///< sqrt mean(Delta E^2 cos theta_i cos theta_o), Delta E of CIE 1976
};

/// The factor of a BRDF value before the comparison.
enum class MetricFactor {
  one,
  cosI,    ///< cos theta_i
  cosines  ///< max(cos theta_i cos theta_o, logRelativeOffset), core/brdf/data_transform.h
};
/// The function of x = factor times BRDF value in which the difference d is computed.
enum class MetricDomain {
  linear,       ///< x
  log,          ///< ln(1 + x)
  cubeRoot,     ///< x^(1/3)
  gamma,        ///< x^(1/g)
  logRelative,  ///< ln(x + logRelativeOffset)
  lab           ///< CIE 1976 L*a*b* of pi x as reflectance factors; the only domain that mixes the channels
};
enum class MetricPower { square, absolute, twoThirds };
/// The factor on the solid angles of a cell.
enum class MetricWeight { one, cosO, cosines };

/// Default g of BrdfMetric::gamma (exponent 1/g).
inline constexpr double defaultGamma = 2;
inline constexpr double minGamma = 1, maxGamma = 3;

/// The complete definition of one metric, for computation and documentation.
struct MetricRecord {
  BrdfMetric metric;
  std::string_view id;       ///< in JSON, on the command line and in lists
  std::string_view alias;    ///< another name of the same metric in the literature, or ""
  std::string_view name;     ///< for display
  std::string_view formula;  ///< in ASCII; differences are between the materials, means are weighted
  std::string_view unit;     ///< of the error; "" for a number without unit
  std::string_view reference;
  MetricFactor factor;
  MetricDomain domain;
  MetricPower power;
  MetricWeight weight = MetricWeight::one;
  bool isRoot = true;       ///< whether the error is the square root of the mean
  bool minimisable = true;  ///< whether a fit can minimise it
};

/// All metrics, in the order of display; the first is the default of fits.
std::span<const MetricRecord> metricRecords();
const MetricRecord& metricRecord(BrdfMetric metric);
/// MetricRecord::metric of all records, in the same order.
std::span<const BrdfMetric> allBrdfMetrics();
/// The metrics that a fit can minimise: the first ones of allBrdfMetrics().
std::span<const BrdfMetric> minimisableMetrics();

/// MetricRecord::id.
std::string_view metricId(BrdfMetric metric);
/// The metric of an id or alias. @throws Error that lists the ids.
BrdfMetric metricByName(std::string_view name);

// Arithmetic of the metrics, shared by their evaluation and minimisation.

/// The factor of a BRDF value at these cosines.
inline double metricFactor(MetricFactor factor, double cosI, double cosO) {
  switch (factor) {
    case MetricFactor::one:
      return 1;
    case MetricFactor::cosI:
      return cosI;
    default:
      return std::max(cosI * cosO, logRelativeOffset);
  }
}

inline double metricWeight(MetricWeight weight, double cosI, double cosO) {
  switch (weight) {
    case MetricWeight::one:
      return 1;
    case MetricWeight::cosO:
      return cosO;
    default:
      return cosI * cosO;
  }
}

/// Calls `visitor` with the function (r, t) -> d of a domain that treats channels separately; r, t >= 0.
template <typename Visitor>
void visitDifference(MetricDomain domain, double gamma, Visitor&& visitor) {
  // ln((r + e) / (t + e)) without cancellation for close values, nor where one is much smaller than the other.
  const auto ofLogarithms = [](double r, double t, double e) {
    const double smaller = r < t ? r : t;
    return std::copysign(fastLog1p(std::abs(r - t) / (smaller + e)), r - t);
  };
  switch (domain) {
    case MetricDomain::log:
      return visitor([ofLogarithms](double r, double t) { return ofLogarithms(r, t, 1); });
    case MetricDomain::cubeRoot:
      return visitor([](double r, double t) { return fastCbrt(r) - fastCbrt(t); });
    case MetricDomain::gamma:
      if (gamma == 2) return visitor([](double r, double t) { return std::sqrt(r) - std::sqrt(t); });
      return visitor([gamma](double r, double t) { return gammaTransformed(r, gamma) - gammaTransformed(t, gamma); });
    case MetricDomain::logRelative:
      return visitor([ofLogarithms](double r, double t) { return ofLogarithms(r, t, logRelativeOffset); });
    default:
      return visitor([](double r, double t) { return r - t; });
  }
}

/// Calls `visitor` with the function d -> |d|^p.
template <typename Visitor>
void visitPower(MetricPower power, Visitor&& visitor) {
  switch (power) {
    case MetricPower::square:
      return visitor([](double d) { return d * d; });
    case MetricPower::absolute:
      return visitor([](double d) { return std::abs(d); });
    default:
      return visitor([](double d) { return fastCbrt(d * d); });
  }
}

/// CIE 1976 L*, a*, b* of a BRDF value (1/sr, linear sRGB, >= 0), where the perfect diffuser, 1 / pi, is white.
Rgb labOf(const Rgb& value);
/// The differences of L*, a*, b* of n pairs of colours. @param reference, test 3 x n, BRDF values as for labOf().
/// @param differences 3 x n, result.
void labDifferences(const Eigen::Array3Xd& reference, const Eigen::Array3Xd& test, Eigen::Array3Xd& differences);

}  // namespace gonio::metrics
