// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/brdf/data_transform.h"
#include "core/brdf/log_relative.h"
#include "core/math/fast_roots_logs.h"
#include "core/math/types.h"
#include "core/metrics/brdf_metric.h"

/// Arithmetic of the metrics, shared by their evaluation and minimisation.
namespace gonio::metrics {

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
  switch (domain) {
    case MetricDomain::log:
      // ln((1 + r) / (1 + t)) without cancellation for small values.
      return visitor([](double r, double t) { return fastLog1p((r - t) / (1 + t)); });
    case MetricDomain::cubeRoot:
      return visitor([](double r, double t) { return fastCbrt(r) - fastCbrt(t); });
    case MetricDomain::gamma:
      if (gamma == 2) return visitor([](double r, double t) { return std::sqrt(r) - std::sqrt(t); });
      return visitor([gamma](double r, double t) { return gammaTransformed(r, gamma) - gammaTransformed(t, gamma); });
    case MetricDomain::logRelative:
      return visitor([](double r, double t) { return fastLog1p((r - t) / (t + logRelativeOffset)); });
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
