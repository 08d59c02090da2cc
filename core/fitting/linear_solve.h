// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <vector>

#include "core/fitting/bounded_least_squares.h"
#include "core/metrics/brdf_metric.h"

namespace gonio::fitting {

/// A metric as a least-squares problem: the residual of one value is `shape(transform(x) - transform(y))`, with x the
/// model's BRDF value times the metric's factor and y the measured one's. The weighted sum of the squared residuals is
/// the metric's sum (core/metrics).
///
/// For x < 0 (models with signed coefficients) the transforms are continued monotonically, so that the solver returns
/// to x >= 0. Slopes are bounded, so that roots near 0 do not dominate. For loops over many values, visitDomain() and
/// visitPower() select the functions once, so that the loop can be vectorised.
class MetricTransform {
 public:
  explicit MetricTransform(metrics::BrdfMetric metric, double gamma = metrics::defaultGamma)
      : record_(&metrics::metricRecord(metric)), domain_(record_->domain), power_(record_->power), gamma_(gamma) {
    assert(record_->minimisable);
  }

  double factor(double cosI, double cosO) const { return metrics::metricFactor(record_->factor, cosI, cosO); }
  /// Factor of the metric on the measure of a cell.
  double weight(double cosI, double cosO) const { return metrics::metricWeight(record_->weight, cosI, cosO); }

  /// Calls `visitor` with two functions of x: transform() and slope().
  template <typename Visitor>
  void visitDomain(Visitor&& visitor) const {
    switch (domain_) {
      case metrics::MetricDomain::cubeRoot:
        return visitor([](double x) { return fastCbrt(x); },
                       [](double x) {
                         const double root = fastCbrt(std::max(std::abs(x), minMagnitude));
                         return 1 / (3 * root * root);
                       });
      case metrics::MetricDomain::log:
        return visitor(
            [](double x) {
              const double y = fastLog1p(std::max(x, 0.0));
              return x < 0 ? x : y;
            },
            [](double x) { return 1 / (1 + std::max(x, 0.0)); });
      case metrics::MetricDomain::gamma:
        if (gamma_ == 2)
          return visitor([](double x) { return std::copysign(std::sqrt(std::abs(x)), x); },
                         [](double x) { return 0.5 / std::sqrt(std::max(std::abs(x), minMagnitude)); });
        return visitor([gamma = gamma_](double x) { return std::copysign(gammaTransformed(std::abs(x), gamma), x); },
                       [gamma = gamma_](double x) {
                         const double bounded = std::max(std::abs(x), minMagnitude);
                         return gammaTransformed(bounded, gamma) / (gamma * bounded);
                       });
      case metrics::MetricDomain::logRelative:
        return visitor(
            [atZero = std::log(offset)](double x) {
              const double y = fastLog1p(std::max(x, 0.0) / offset);
              return atZero + (x < 0 ? x / offset : y);
            },
            [](double x) { return 1 / (std::max(x, 0.0) + offset); });
      default:
        return visitor([](double x) { return x; }, [](double) { return 1.0; });
    }
  }
  double transform(double x) const {
    double y = 0;
    visitDomain([&](const auto& function, const auto&) { y = function(x); });
    return y;
  }
  /// Derivative of transform().
  double slope(double x) const {
    double y = 0;
    visitDomain([&](const auto&, const auto& derivative) { y = derivative(x); });
    return y;
  }

  /// Calls `visitor` with two functions of d: reweight(), and shapeSlope() / reweight().
  template <typename Visitor>
  void visitPower(Visitor&& visitor) const {
    switch (power_) {
      case metrics::MetricPower::absolute:
        return visitor([](double d) { return 1 / std::sqrt(std::sqrt(d * d + kink * kink)); },
                       [](double d) { return 1 - d * d / (2 * (d * d + kink * kink)); });
      case metrics::MetricPower::twoThirds:
        return visitor([](double d) { return 1 / fastCbrt(d * d + kink * kink); },
                       [](double d) { return 1 - 2 * d * d / (3 * (d * d + kink * kink)); });
      default:
        return visitor([](double) { return 1.0; }, [](double) { return 1.0; });
    }
  }
  bool isReweighted() const { return power_ != metrics::MetricPower::square; }
  /// The residual of a difference d: d itself for quadratic metrics; for metrics that are means of |d|^p, a smooth
  /// function with a square of about |d|^p.
  double shape(double d) const { return d * reweight(d); }
  double shapeSlope(double d) const {
    double y = 0;
    visitPower([&](const auto& weight, const auto& slope) { y = weight(d) * slope(d); });
    return y;
  }
  /// shape(d) / d: the square root of the weight in iteratively reweighted least squares.
  double reweight(double d) const {
    double y = 0;
    visitPower([&](const auto& weight, const auto&) { y = weight(d); });
    return y;
  }

 private:
  static constexpr double minMagnitude = 1e-6;  ///< lower bound of |x| for the slopes of roots
  static constexpr double kink = 1e-4;          ///< half-width of the rounded minimum of |d|
  static constexpr double offset = logRelativeOffset;

  const metrics::MetricRecord* record_;
  metrics::MetricDomain domain_;
  metrics::MetricPower power_;
  double gamma_;
};

/// The fit of one colour channel for fixed non-linear parameters: the model is sum_j p_j basis_j.
struct ChannelProblem {
  MetricTransform metric;
  std::span<const double> factor;  ///< factor of the metric per BRDF value
  std::span<const double> rootWeight;
  std::span<const double> transformed;  ///< transform(measured * factor)
  std::span<const double> startWeight;  ///< rootWeight * slope(measured * factor) * factor
  std::span<const double> values;       ///< measured, 1/sr
  std::vector<std::span<const double>> bases;
  LinearVector lower, upper;
  double costTolerance = 1e-13;  ///< relative change of the cost at which iterations stop

  std::size_t size() const { return factor.size(); }
  /// The model in all cells, 1/sr.
  std::vector<double> model(const LinearVector& p) const;
  /// The model in values.size() cells from `begin` on.
  void evaluateModel(const LinearVector& p, std::size_t begin, std::span<double> values) const;
};

struct ChannelSolution {
  LinearVector parameters;
  double cost = 0;                  ///< sum of squared residuals
  std::vector<double> model;        ///< in the cells, 1/sr
  std::vector<double> differences;  ///< transform(model * factor) - transformed
  std::vector<double> residuals;    ///< rootWeight * shape(difference)
};

/// Bounded least squares in the metric's own domain by Gauss-Newton steps, each an exact bounded linear problem, with
/// step halving, so that the cost never rises. For metrics without a transform the first step is the solution.
/// @param guess the start; empty: the solution linearised at the measurement.
ChannelSolution solveLinearParameters(const ChannelProblem& problem, const LinearVector& guess);

}  // namespace gonio::fitting
