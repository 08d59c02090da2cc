// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/nonparametric.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/brdf/brdf.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

using Eigen::Index;

constexpr std::size_t nodeCount = NonparametricFactors::nodes;
using NodeValues = std::array<double, nodeCount>;

/// A valid node of the samples.
struct Cell {
  std::size_t sample, h, d;
  NodeInterval i, o;  ///< of G
  double measure;     ///< of both solid angles and of the error in x = rho cos theta_i cos theta_o
  double cosines;     ///< cos theta_i cos theta_o
};

std::vector<Cell> cellsOf(const HalfDifferenceSamples& s) {
  std::vector<Cell> cells;
  for (std::size_t h = 0, i = 0; h < nodeCount; ++h)
    for (std::size_t d = 0; d < nodeCount; ++d)
      for (std::size_t p = 0; p < s.axes.phiD.size(); ++p, ++i) {
        if (!s.valid[i]) continue;
        const double cosines = s.cosI[i] * s.cosO[i];
        cells.push_back({.sample = i,
                         .h = h,
                         .d = d,
                         .i = maskingInterval(std::acos(std::min(1.0, s.cosI[i]))),
                         .o = maskingInterval(std::acos(std::min(1.0, s.cosO[i]))),
                         .measure = projectedMeasure(s, h, d, p) * cosines,
                         .cosines = cosines});
      }
  return cells;
}

/// rho = base + d f g g / cosines of one channel.
class ChannelFit {
 public:
  ChannelFit(const std::vector<Cell>& cells, const HalfDifferenceSamples& s, int channel) : cells_(cells) {
    for (const Cell& cell : cells) {
      const double rho = s.values[cell.sample][channel], x = rho * cell.cosines;
      const double compression = x > 0 ? std::log1p(x) / x : 1;
      values_.push_back(rho);
      weights_.push_back(cell.measure * compression * compression);
      total_ += weights_.back() * rho * rho;
    }
    start();
  }

  /// Relative to the norm of the data.
  double residual() const { return total_ > 0 ? std::sqrt(leftOver(g_) / total_) : 0; }

  void sweep() {
    updateCurve(d_, f_, &Cell::h, &Cell::d);
    updateCurve(f_, d_, &Cell::d, &Cell::h);
    updateBase();
    updateMasking();
  }

  NonparametricFactors::Channel factors() const {
    NonparametricFactors::Channel result{.diffuse = base_ * pi, .specular = pi, .d = d_, .f = f_, .g = g_};
    for (const auto& [curve, power] : {std::pair(&result.d, 1), std::pair(&result.f, 1), std::pair(&result.g, 2)}) {
      const double largest = *std::max_element(curve->begin(), curve->end());
      if (!(largest > 0)) continue;
      for (double& value : *curve) value /= largest;
      result.specular *= power == 1 ? largest : largest * largest;
    }
    return result;
  }

 private:
  static double at(const NodeValues& g, const NodeInterval& place) {
    return (1 - place.fraction) * g[place.index] + place.fraction * g[place.index + 1];
  }
  double masking(const Cell& cell, const NodeValues& g) const { return at(g, cell.i) * at(g, cell.o) / cell.cosines; }

  double leftOver(const NodeValues& g) const {
    double sum = 0;
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const Cell& cell = cells_[k];
      const double error = values_[k] - base_ - d_[cell.h] * f_[cell.d] * masking(cell, g);
      sum += weights_[k] * error * error;
    }
    return sum;
  }

  /// No shadowing, no Fresnel effect; D from the mean at each theta_h, half of the smallest of which is diffuse.
  void start() {
    f_.fill(1);
    for (std::size_t i = 0; i < nodeCount; ++i) g_[i] = std::cos(radians(double(i) + 0.5));
    NodeValues sums{}, weights{};
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      sums[cells_[k].h] += weights_[k] * values_[k];
      weights[cells_[k].h] += weights_[k];
    }
    base_ = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < nodeCount; ++i)
      if (weights[i] > 0) base_ = std::min(base_, sums[i] / weights[i] / 2);
    if (cells_.empty()) base_ = 0;
    for (std::size_t i = 0; i < nodeCount; ++i) d_[i] = weights[i] > 0 ? sums[i] / weights[i] - base_ : 0;
  }

  void updateCurve(NodeValues& curve, const NodeValues& other, std::size_t Cell::*own, std::size_t Cell::*others) {
    NodeValues products{}, squares{};
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const Cell& cell = cells_[k];
      const double factor = other[cell.*others] * masking(cell, g_);
      products[cell.*own] += weights_[k] * factor * (values_[k] - base_);
      squares[cell.*own] += weights_[k] * factor * factor;
    }
    for (std::size_t i = 0; i < nodeCount; ++i)
      if (squares[i] > 0) curve[i] = std::max(0.0, products[i] / squares[i]);
  }

  void updateBase() {
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const Cell& cell = cells_[k];
      sum += weights_[k] * (values_[k] - d_[cell.h] * f_[cell.d] * masking(cell, g_));
      weights += weights_[k];
    }
    if (weights > 0) base_ = std::max(0.0, sum / weights);
  }

  /// G stands twice in a cell.
  void updateMasking() {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(nodeCount, nodeCount);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(nodeCount);
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const Cell& cell = cells_[k];
      const double lobe = d_[cell.h] * f_[cell.d] / cell.cosines, gI = at(g_, cell.i), gO = at(g_, cell.o);
      const double error = values_[k] - base_ - lobe * gI * gO;
      const Index unknowns[] = {Index(cell.i.index), Index(cell.i.index) + 1, Index(cell.o.index),
                                Index(cell.o.index) + 1};
      const double slopes[] = {lobe * gO * (1 - cell.i.fraction), lobe * gO * cell.i.fraction,
                               lobe * gI * (1 - cell.o.fraction), lobe * gI * cell.o.fraction};
      for (int a = 0; a < 4; ++a) {
        right[unknowns[a]] += weights_[k] * slopes[a] * error;
        for (int b = 0; b < 4; ++b) matrix(unknowns[a], unknowns[b]) += weights_[k] * slopes[a] * slopes[b];
      }
    }
    takeDampedStep(matrix, right);
  }

  /// Levenberg and Marquardt: nodes that the lobe hardly reaches stay where they are.
  void takeDampedStep(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
    const double unit = matrix.trace() / nodeCount, before = leftOver(g_);
    if (!(unit > 0)) return;
    for (const double damping : {1e-3, 1e-1, 10.0, 1000.0}) {
      Eigen::MatrixXd damped = matrix;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-9 * unit;
      const Eigen::VectorXd step = solveSymmetric(damped, right);
      NodeValues trial;
      for (std::size_t i = 0; i < nodeCount; ++i) trial[i] = std::max(0.0, g_[i] + step[Index(i)]);
      if (!(leftOver(trial) < before)) continue;
      g_ = trial;
      return;
    }
  }

  const std::vector<Cell>& cells_;
  std::vector<double> values_, weights_;
  double total_ = 0, base_ = 0;
  NodeValues d_{}, f_{}, g_{};
};

}  // namespace

HalfDifferenceAxes nonparametricAxes() { return makeHalfDifferenceAxes(int(nodeCount), int(nodeCount), 10); }

NonparametricFit fitNonparametric(const HalfDifferenceSamples& samples, const NonparametricOptions& options,
                                  const TaskControl& control) {
  assert(samples.axes.thetaH.size() == nodeCount && samples.axes.thetaD.size() == nodeCount);
  const std::vector<Cell> cells = cellsOf(samples);
  NonparametricFit result;
  parallelForBlocks(3, 1,
                    [&](std::size_t channel, std::size_t) {
                      ChannelFit fit(cells, samples, int(channel));
                      std::vector<double>& residuals = result.residuals[channel];
                      residuals.push_back(fit.residual());
                      for (int sweep = 0; sweep < options.maxSweeps; ++sweep) {
                        control.throwIfStopped();
                        fit.sweep();
                        residuals.push_back(fit.residual());
                        const double before = residuals[residuals.size() - 2];
                        if (!(before - residuals.back() > options.tolerance * before)) break;
                      }
                      result.factors.channels[channel] = fit.factors();
                    },
                    {.stop = control.stop});
  return result;
}

namespace {

double between(const std::array<double, NonparametricFactors::nodes>& curve, const NodeInterval& at) {
  return (1 - at.fraction) * curve[at.index] + at.fraction * curve[at.index + 1];
}

const double smallestCosine = std::cos(radians(89.5));

}  // namespace

NodeInterval nonparametricInterval(double position) {
  const double x = std::clamp(position, 0.0, double(NonparametricFactors::nodes - 1));
  const std::size_t index = std::min(std::size_t(x), NonparametricFactors::nodes - 2);
  return {index, x - double(index)};
}

std::shared_ptr<const Brdf> makeNonparametricBrdf(NonparametricFactors factors) {
  return makePairwiseBrdf([f = std::move(factors)](const Direction& wi, const Direction& wo) {
    const HalfDifference at = toHalfDifference(wi, wo);
    Rgb result(0);
    if (!at.valid) return result;
    const HalfDifferenceGrid::Position position = HalfDifferenceGrid{}.position(at);
    const NodeInterval d = nonparametricInterval(position.thetaH), fresnel = nonparametricInterval(position.thetaD),
                       i = maskingInterval(polarAngle(wi)), o = maskingInterval(polarAngle(wo));
    const double cosines = std::max(wi.z, smallestCosine) * std::max(wo.z, smallestCosine);
    for (int channel = 0; channel < 3; ++channel) {
      const NonparametricFactors::Channel& c = f.channels[std::size_t(channel)];
      const double lobe = between(c.d, d) * between(c.f, fresnel) * between(c.g, i) * between(c.g, o) / cosines;
      result[channel] = (c.diffuse + c.specular * lobe) / pi;
    }
    return result;
  });
}

}  // namespace gonio::factorization
