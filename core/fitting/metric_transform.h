// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/metrics/metric_domain.h"

namespace gonio::fitting {

/// A metric as least squares: the residual of one value is `shape(transform(x) - transform(y))` with x the reflectance
/// of the model times the metric's factor and y that of the measurement; the sum of the squares is the metric's sum
/// (core/metrics).
class MetricTransform {
 public:
  explicit MetricTransform(metrics::BrdfMetric metric, double gamma = metrics::defaultGamma)
      : record_(&metrics::metricRecord(metric)), domain_(record_->domain), power_(record_->power), gamma_(gamma) {
    assert(record_->minimisable);
  }

  double factor(double cosI, double cosO) const { return metrics::metricFactor(record_->factor, cosI, cosO); }
  /// What the metric multiplies the measure of a cell by.
  double weight(double cosI, double cosO) const { return metrics::metricWeight(record_->weight, cosI, cosO); }

  /// Calls `visitor` with the function x -> y of the domain, for loops over many values. Of x below 0 (a model with
  /// signed coefficients) the straight continuation, so that the solver is led back.
  template <typename Visitor>
  void visitTransform(Visitor&& visitor) const {
    switch (domain_) {
      case metrics::MetricDomain::cubeRoot:
        return visitor([](double x) { return fastCbrt(x); });
      case metrics::MetricDomain::log:
        return visitor([](double x) { return x < 0 ? x : fastLog1p(std::max(x, 0.0)); });
      case metrics::MetricDomain::gamma:
        return visitor(
            [gamma = gamma_](double x) { return x < 0 ? -gammaTransformed(-x, gamma) : gammaTransformed(x, gamma); });
      case metrics::MetricDomain::logRelative:
        return visitor([atZero = std::log(offset)](double x) {
          return atZero + (x < 0 ? x / offset : fastLog1p(std::max(x, 0.0) / offset));
        });
      default:
        return visitor([](double x) { return x; });
    }
  }
  double transform(double x) const {
    double y = 0;
    visitTransform([&](const auto& function) { y = function(x); });
    return y;
  }
  /// Derivative of transform(); bounded, so that a root at 0 does not swallow all other cells.
  double slope(double x) const {
    switch (domain_) {
      case metrics::MetricDomain::cubeRoot: {
        const double root = fastCbrt(std::max(std::abs(x), smallest));
        return 1 / (3 * root * root);
      }
      case metrics::MetricDomain::log:
        return 1 / (1 + std::max(x, 0.0));
      case metrics::MetricDomain::gamma: {
        const double bounded = std::max(std::abs(x), smallest);
        return gammaTransformed(bounded, gamma_) / (gamma_ * bounded);
      }
      case metrics::MetricDomain::logRelative:
        return 1 / (std::max(x, 0.0) + offset);
      default:
        return 1;
    }
  }

  bool isReweighted() const { return power_ != metrics::MetricPower::square; }
  /// d for the quadratic metrics; for the means of |d|^p a smooth function whose square tends to |d|^p.
  double shape(double d) const { return isReweighted() ? d * reweight(d) : d; }
  double shapeSlope(double d) const {
    const double square = d * d + kink * kink;
    switch (power_) {
      case metrics::MetricPower::absolute:
        return reweight(d) * (1 - d * d / (2 * square));
      case metrics::MetricPower::twoThirds:
        return reweight(d) * (1 - 2 * d * d / (3 * square));
      default:
        return 1;
    }
  }
  /// shape(d) / d: the weight of iteratively reweighted least squares.
  double reweight(double d) const {
    switch (power_) {
      case metrics::MetricPower::absolute:
        return 1 / std::sqrt(std::sqrt(d * d + kink * kink));
      case metrics::MetricPower::twoThirds:
        return 1 / fastCbrt(d * d + kink * kink);
      default:
        return 1;
    }
  }

 private:
  static constexpr double smallest = 1e-6;  ///< 1/sr; reflectances below count as this for the slope of a root
  static constexpr double kink = 1e-4;      ///< half width of the rounded tip of |d|
  static constexpr double offset = metrics::logRelativeOffset;

  const metrics::MetricRecord* record_;
  metrics::MetricDomain domain_;
  metrics::MetricPower power_;
  double gamma_;
};

}  // namespace gonio::fitting
