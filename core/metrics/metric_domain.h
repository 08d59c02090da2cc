// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/brdf/data_transform.h"
#include "core/math/types.h"
#include "core/metrics/brdf_metric.h"

/// The arithmetic of the metrics, for those that sum errors and those that minimise them.
namespace gonio::metrics {

/// What a reflectance of these two cosines is multiplied by.
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

/// Calls `visitor` with the function (r, t) -> d of one domain that treats each channel alone; r, t >= 0.
template <typename Visitor>
void visitDifference(MetricDomain domain, double gamma, Visitor&& visitor) {
  switch (domain) {
    case MetricDomain::log:
      // ln((1 + r) / (1 + t)) without cancellation for small values.
      return visitor([](double r, double t) { return std::log1p((r - t) / (1 + t)); });
    case MetricDomain::cubeRoot:
      return visitor([](double r, double t) { return std::cbrt(r) - std::cbrt(t); });
    case MetricDomain::gamma:
      return visitor([gamma](double r, double t) { return gammaTransformed(r, gamma) - gammaTransformed(t, gamma); });
    case MetricDomain::logRelative:
      return visitor([](double r, double t) { return std::log1p((r - t) / (t + logRelativeOffset)); });
    default:
      return visitor([](double r, double t) { return r - t; });
  }
}

inline double metricPower(MetricPower power, double d) {
  switch (power) {
    case MetricPower::square:
      return d * d;
    case MetricPower::absolute:
      return std::abs(d);
    default:
      return std::cbrt(d * d);
  }
}

/// CIE 1976 L*, a*, b* of a reflectance (1/sr, linear sRGB primaries, >= 0); the perfect diffuser, 1 / pi, is white.
Rgb labOf(const Rgb& reflectance);

}  // namespace gonio::metrics
