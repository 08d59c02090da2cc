// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/metrics/brdf_metrics.h"

namespace gonio::fitting {

/// A metric as least squares: the residual of one value is `shape(transform(x) - transform(y))` with x = rho cos
/// theta_i of the model and y that of the measurement; the sum of the squares is the metric's sum (core/metrics).
class MetricTransform {
 public:
  explicit MetricTransform(metrics::BrdfMetric metric) : metric_(metric) {}

  double transform(double x) const {
    switch (metric_) {
      case metrics::BrdfMetric::cosineL2:
        return x;
      case metrics::BrdfMetric::cubeRoot:
        return std::cbrt(x);
      default:
        return std::log1p(x);
    }
  }
  /// Derivative of transform(); bounded, so that a cube root at 0 does not swallow all other cells.
  double slope(double x) const {
    switch (metric_) {
      case metrics::BrdfMetric::cosineL2:
        return 1;
      case metrics::BrdfMetric::cubeRoot: {
        const double root = std::cbrt(std::max(x, smallest));
        return 1 / (3 * root * root);
      }
      default:
        return 1 / (1 + x);
    }
  }

  /// d for the quadratic metrics; for the mean of |d| a smooth function whose square tends to |d|.
  double shape(double d) const { return isAbsolute() ? d * reweight(d) : d; }
  double shapeSlope(double d) const {
    if (!isAbsolute()) return 1;
    const double square = d * d + kink * kink;
    return reweight(d) * (1 - 0.5 * d * d / square);
  }
  /// shape(d) / d: the weight of iteratively reweighted least squares.
  double reweight(double d) const { return isAbsolute() ? 1 / std::sqrt(std::sqrt(d * d + kink * kink)) : 1; }

 private:
  static constexpr double smallest = 1e-6;  ///< 1/sr; reflectances below count as this for the slope of the cube root
  static constexpr double kink = 1e-4;      ///< half width of the rounded tip of |d|

  bool isAbsolute() const { return metric_ == metrics::BrdfMetric::meanAbsoluteLog; }

  metrics::BrdfMetric metric_;
};

}  // namespace gonio::fitting
