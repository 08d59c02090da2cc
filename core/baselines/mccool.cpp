// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/mccool.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/brdf.h"
#include "core/factorization/deviation_grid.h"
#include "core/math/decompositions.h"
#include "core/math/monotone_cubic.h"

namespace gonio::baselines {

namespace {

using Eigen::Index;

constexpr int curveNodes = 90;
/// The bias of the logarithm as a fraction of the mean value of a channel.
constexpr double biasFraction = 1e-2;
/// Weights of second differences, and of the size of the unknowns, relative to the mean weight of an unknown: the
/// latter settles how p and q share a constant.
constexpr double smoothness = 1e-5, size = 1e-10;

/// Where the three factors of a cell read: six unknowns and their shares.
struct CellRow {
  Index unknowns[6];
  double fractions[6];
};

CellRow rowOf(const McCoolFactors& f, double cosI, double cosO, double thetaH) {
  CellRow row;
  const auto store = [&row](int at, Index offset, const NodeInterval& place) {
    row.unknowns[at] = offset + Index(place.index);
    row.unknowns[at + 1] = offset + Index(place.index) + 1;
    row.fractions[at] = 1 - place.fraction;
    row.fractions[at + 1] = place.fraction;
  };
  store(0, 0, findInterval(f.theta, std::acos(std::min(1.0, cosI))));
  store(2, 0, findInterval(f.theta, std::acos(std::min(1.0, cosO))));
  store(4, Index(f.theta.size()), findInterval(f.thetaH, thetaH));
  return row;
}

/// sum of weight (shares . x - ln(rho + bias))^2 over the cells, as normal equations.
struct NormalEquations {
  Eigen::MatrixXd matrix;
  std::array<Eigen::VectorXd, 3> right;
};

/// Weighted mean of the values.
Rgb meanValue(const factorization::HalfDifferenceSamples& s) {
  Rgb sum(0);
  double weights = 0;
  for (std::size_t h = 0, i = 0; h < s.axes.thetaH.size(); ++h)
    for (std::size_t d = 0; d < s.axes.thetaD.size(); ++d)
      for (std::size_t p = 0; p < s.axes.phiD.size(); ++p, ++i) {
        const double weight = projectedMeasure(s, h, d, p);
        sum += weight * s.values[i];
        weights += weight;
      }
  return weights > 0 ? sum / weights : Rgb(0);
}

NormalEquations accumulate(const factorization::HalfDifferenceSamples& s, const McCoolFactors& f,
                           const TaskControl& control) {
  const Index count = Index(f.theta.size() + f.thetaH.size());
  NormalEquations equations{.matrix = Eigen::MatrixXd::Zero(count, count), .right = {}};
  equations.right.fill(Eigen::VectorXd::Zero(count));
  for (std::size_t h = 0, i = 0; h < s.axes.thetaH.size(); ++h) {
    control.throwIfStopped();
    for (std::size_t d = 0; d < s.axes.thetaD.size(); ++d)
      for (std::size_t p = 0; p < s.axes.phiD.size(); ++p, ++i) {
        const double weight = projectedMeasure(s, h, d, p);
        if (!(weight > 0)) continue;
        const CellRow row = rowOf(f, s.cosI[i], s.cosO[i], s.axes.thetaH[h]);
        for (int a = 0; a < 6; ++a) {
          for (int b = 0; b < 6; ++b)
            equations.matrix(row.unknowns[a], row.unknowns[b]) += weight * row.fractions[a] * row.fractions[b];
          for (std::size_t channel = 0; channel < 3; ++channel)
            if (const double bias = f.channels[channel].bias; bias > 0)
              equations.right[channel][row.unknowns[a]] +=
                  weight * row.fractions[a] * std::log(s.values[i][int(channel)] + bias);
        }
      }
  }
  return equations;
}

void holdSmooth(Eigen::MatrixXd& matrix, Index begin, Index end, double weight) {
  const double stencil[] = {1, -2, 1};
  for (Index i = begin; i + 2 < end; ++i)
    for (Index a = 0; a < 3; ++a)
      for (Index b = 0; b < 3; ++b) matrix(i + a, i + b) += weight * stencil[a] * stencil[b];
}

}  // namespace

factorization::HalfDifferenceAxes mcCoolAxes() { return factorization::makeHalfDifferenceAxes(90, 90, 10); }

McCoolFactors factorizeMcCool(const factorization::HalfDifferenceSamples& samples, const TaskControl& control) {
  McCoolFactors f{.thetaH = samples.axes.thetaH};
  for (int i = 0; i < curveNodes; ++i) f.theta.push_back(factorization::maxPolarAngle * i / (curveNodes - 1));
  const Rgb mean = meanValue(samples);
  for (int channel = 0; channel < 3; ++channel) {
    McCoolFactors::Channel& c = f.channels[std::size_t(channel)];
    c.bias = biasFraction * mean[channel];
    if (!(c.bias > 0)) continue;
    double highest = 0;
    for (const Rgb& value : samples.values) highest = std::max(highest, value[channel]);
    c.highest = std::log(highest + c.bias);
  }
  NormalEquations equations = accumulate(samples, f, control);
  Eigen::MatrixXd& matrix = equations.matrix;
  const Index split = Index(f.theta.size()), count = matrix.rows();
  const double unit = std::max(matrix.trace() / double(count), 1e-30);
  holdSmooth(matrix, 0, split, smoothness * unit);
  holdSmooth(matrix, split, count, smoothness * unit);
  matrix.diagonal().array() += size * unit;
  Eigen::MatrixXd right(count, 3);
  for (std::size_t channel = 0; channel < 3; ++channel) right.col(Index(channel)) = equations.right[channel];
  const Eigen::MatrixXd solution = solveSymmetric(matrix, right);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto x = solution.col(Index(channel));
    f.channels[channel].logP.assign(x.data(), x.data() + split);
    f.channels[channel].logQ.assign(x.data() + split, x.data() + count);
  }
  return f;
}

std::shared_ptr<const Brdf> makeMcCoolBrdf(McCoolFactors factors) {
  return makePairwiseBrdf([f = std::move(factors)](const Direction& wi, const Direction& wo) {
    const HalfDifference at = toHalfDifference(wi, wo);
    Rgb result(0);
    if (!at.valid) return result;
    const CellRow row = rowOf(f, wi.z, wo.z, at.thetaH);
    const Index split = Index(f.theta.size());
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const McCoolFactors::Channel& c = f.channels[channel];
      if (!(c.bias > 0)) continue;
      double sum = 0;
      for (int a = 0; a < 6; ++a) {
        const Index unknown = row.unknowns[a];
        sum +=
            row.fractions[a] * (unknown < split ? c.logP[std::size_t(unknown)] : c.logQ[std::size_t(unknown - split)]);
      }
      result[int(channel)] = std::max(0.0, std::exp(std::min(sum, c.highest)) - c.bias);
    }
    return result;
  });
}

}  // namespace gonio::baselines
