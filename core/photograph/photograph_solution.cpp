// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph_solution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gonio::photograph {

using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixX3d, Eigen::VectorXd;

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

MatrixX3d rowsOf(const MatrixX3d& matrix, const std::vector<std::size_t>& chosen) { return matrix(chosen, Eigen::all); }

/// The squared differences of data and linearised pixel values about x, as a function of x.
struct Quadratic {
  VectorXd x;
  MatrixXd curvature;  ///< J^T W J
  VectorXd slope;      ///< J^T W (data - values)
  double energy = 0;   ///< (data - values)^T W (data - values)

  Quadratic(const PixelProblem& problem, const PixelLinearisation& at, const VectorXd& about, const MatrixX3d& weights)
      : x(about), curvature(MatrixXd::Zero(about.size(), about.size())), slope(VectorXd::Zero(about.size())) {
    const Index components = problem.components();
    for (Index channel = 0; channel < channelCount; ++channel) {
      const MatrixXd& jacobian = at.jacobian[std::size_t(channel)];
      const VectorXd difference = problem.data.col(channel) - at.values.col(channel), weight = weights.col(channel);
      const MatrixXd weighted = weight.asDiagonal() * jacobian;
      const Index first = channel * components;
      curvature.block(first, first, components, components).noalias() = jacobian.transpose() * weighted;
      slope.segment(first, components) = weighted.transpose() * difference;
      energy += difference.dot(weight.cwiseProduct(difference));
    }
  }
};

struct Solution {
  VectorXd w;
  Eigen::LLT<MatrixXd> normal;  ///< inverse of the covariance of w given the photographs
  double evidence = 0;          ///< logarithm of the probability of the photographs, up to terms in their variances
};

Solution solved(const Quadratic& of, const LocalPrior& prior) {
  const VectorXd step = of.x - prior.mean;
  const VectorXd slope = of.slope + of.curvature * step;
  const VectorXd right = prior.factor.transpose() * slope;
  MatrixXd normal = prior.factor.transpose() * (of.curvature * prior.factor);
  normal.diagonal().array() += 1;
  Solution result;
  result.normal.compute(normal);
  result.w = result.normal.solve(right);
  const double energy = of.energy + step.dot(of.slope + slope);
  const double logDeterminant = 2 * result.normal.matrixLLT().diagonal().array().log().sum();
  result.evidence = -0.5 * (energy - right.dot(result.w) + logDeterminant);
  return result;
}

constexpr std::array<double, 5> triedBandwidths{0.11, 0.22, 0.44, 0.89, unbounded};
constexpr std::array<double, 7> triedNoises{0.0025, 0.005, 0.01, 0.02, 0.04, 0.08, 0.16};

/// The state of the iterations.
struct State {
  std::size_t bandwidth = 2;  ///< in triedBandwidths
  double modelNoise = 0.04;
  VectorXd w, x;
  PixelLinearisation at;
};

/// Twice the negative logarithm of the probability of x = mean + G w, up to a constant.
double costOf(const PixelProblem& problem, const VectorXd& x, const VectorXd& w, const MatrixX3d& weights) {
  const MatrixX3d difference = problem.data - pixelValues(problem.prior, problem.rows, problem.coefficients(x));
  return difference.cwiseProduct(difference).cwiseProduct(weights).sum() + w.squaredNorm();
}

/// Steps of Gauss and Newton with a fixed prior and noise. A step is shortened until it lowers the cost.
void iterate(const PixelProblem& problem, const LocalPrior& prior, int steps, State& state,
             const TaskControl& control) {
  const MatrixX3d weights = problem.weights(state.modelNoise);
  double cost = costOf(problem, state.x, state.w, weights);
  for (int step = 0; step < steps; ++step) {
    control.throwIfStopped();
    const VectorXd target = solved(Quadratic(problem, state.at, state.x, weights), prior).w;
    constexpr int trials = 6;
    constexpr double shorter = 0.4, negligible = 1e-3;
    double length = 1, gain = 0;
    for (int trial = 0; trial < trials && !(gain > 0); ++trial, length *= shorter) {
      const VectorXd w = state.w + length * (target - state.w), x = prior.mean + prior.factor * w;
      const double tried = costOf(problem, x, w, weights);
      if (!(tried < cost)) continue;
      gain = cost - tried;
      cost = tried;
      state.w = w;
      state.x = x;
    }
    if (!(gain > 0)) return;
    state.at = linearised(problem.prior, problem.rows, problem.coefficients(state.x), control);
    if (gain < negligible * cost) return;
  }
}

/// Chooses the noise, and the bandwidth among `bandwidths`, of the largest evidence about the linearisation, which is
/// the result.
double choose(const PixelProblem& problem, const std::vector<LocalPrior>& priors,
              const std::vector<std::size_t>& bandwidths, State& state, const TaskControl& control) {
  double evidence = -unbounded;
  State best = state;
  for (const double noise : triedNoises) {
    const MatrixX3d weights = problem.weights(noise);
    const double logWeights = 0.5 * problem.share * (weights.array() / problem.share).log().sum();
    const Quadratic quadratic(problem, state.at, state.x, weights);
    for (const std::size_t bandwidth : bandwidths) {
      control.throwIfStopped();
      const Solution solution = solved(quadratic, priors[bandwidth]);
      if (!(solution.evidence + logWeights > evidence)) continue;
      evidence = solution.evidence + logWeights;
      best.bandwidth = bandwidth;
      best.modelNoise = noise;
      best.w = solution.w;
      best.x = priors[bandwidth].mean + priors[bandwidth].factor * solution.w;
    }
  }
  state = std::move(best);
  state.at = linearised(problem.prior, problem.rows, problem.coefficients(state.x), control);
  return evidence;
}

/// Mean difference of the logarithms of the data and of the training signals' pixel values.
double meanLogRatio(const std::array<MatrixXd, 3>& images, const MatrixX3d& values) {
  double sum = 0, count = 0;
  for (Index channel = 0; channel < channelCount; ++channel)
    for (Index row = 0; row < values.rows(); ++row)
      if (values(row, channel) > 0) {
        sum += std::log(values(row, channel)) - images[std::size_t(channel)].row(row).mean();
        ++count;
      }
  return count > 0 ? sum / count : 0;
}

}  // namespace

PixelProblem PixelProblem::dividedBy(double exposure) const {
  return {prior, rows, data / exposure, noise / (exposure * exposure), share};
}

double unexplainedSnr(const MatrixX3d& values, const MatrixX3d& noise, const MatrixX3d& differences) {
  const double energy = differences.squaredNorm();
  return 10 * std::log10(values.squaredNorm() / std::max(energy - noise.sum(), 0.1 * energy));
}

double widening(double unexplainedSnr, std::size_t images) {
  // The regression of the logarithm (docs/results/photographs.md), within the residuals that it had.
  constexpr double lowest = 10, highest = 40, atZero = 0.956, perDecibel = 0.0315, ofImages = 0.4;
  return std::exp(atZero - perDecibel * std::clamp(unexplainedSnr, lowest, highest)) *
         std::pow(double(images), ofImages);
}

PixelRows rowsAt(const PixelRows& rows, const std::vector<std::size_t>& chosen) {
  PixelRows result;
  result.first.push_back(0);
  for (const std::size_t row : chosen) {
    const auto begin = std::ptrdiff_t(rows.first[row]), end = std::ptrdiff_t(rows.first[row + 1]);
    result.cells.insert(result.cells.end(), rows.cells.begin() + begin, rows.cells.begin() + end);
    result.weights.insert(result.weights.end(), rows.weights.begin() + begin, rows.weights.begin() + end);
    result.first.push_back(result.cells.size());
    result.lost.push_back(rows.lost[row]);
  }
  return result;
}

ComparedSignals comparedSignals(const PixelProblem& problem, std::size_t most, const TaskControl& control) {
  ComparedSignals compared{.rows = evenlySpaced(problem.rows.count(), most), .images = {}};
  compared.images = signalImages(problem.prior, rowsAt(problem.rows, compared.rows), control);
  return compared;
}

MostLikely mostLikely(const PixelProblem& problem, const ComparedSignals& compared, const TaskControl& control) {
  const MatrixX3d distances =
      signalDistances(compared.images, rowsOf(problem.data, compared.rows), rowsOf(problem.noise, compared.rows));
  std::vector<LocalPrior> priors;
  priors.reserve(std::size(triedBandwidths));
  for (const double bandwidth : triedBandwidths)
    priors.push_back(localPrior(problem.prior.v, distances, bandwidth, true));
  State state;
  state.x = priors[state.bandwidth].mean;
  state.w = VectorXd::Zero(state.x.size());
  state.at = linearised(problem.prior, problem.rows, problem.coefficients(state.x), control);
  iterate(problem, priors[state.bandwidth], 5, state, control);
  control.report(0.5);
  choose(problem, priors, {0, 1, 2, 3, 4}, state, control);
  iterate(problem, priors[state.bandwidth], 3, state, control);
  control.report(0.8);
  const double evidence = choose(problem, priors, {state.bandwidth}, state, control);
  iterate(problem, priors[state.bandwidth], 2, state, control);
  control.report(1);
  return {std::move(priors[state.bandwidth]),
          triedBandwidths[state.bandwidth],
          state.modelNoise,
          std::move(state.x),
          std::move(state.at),
          evidence};
}

Eigen::LLT<MatrixXd> inverseCovariance(const PixelProblem& problem, const PixelLinearisation& at, const VectorXd& x,
                                       const MatrixX3d& weights, const LocalPrior& prior) {
  return solved(Quadratic(problem, at, x, weights), prior).normal;
}

ExposureEvidence exposureEvidence(const PixelProblem& problem, const ComparedSignals& compared, bool isStated,
                                  std::size_t images, const TaskControl& control) {
  constexpr int most = 20, usual = 5;
  const double start = isStated ? 0 : meanLogRatio(compared.images, rowsOf(problem.data, compared.rows));
  const double step = std::log(2), perLogarithm = problem.share * double(channelCount) * double(problem.rows.count());
  std::map<int, MostLikely> tried;
  const auto at = [&](int place) -> const MostLikely& {
    if (const auto known = tried.find(place); known != tried.end()) return known->second;
    const double logarithm = start + place * step, done = std::min(1.0, double(tried.size()) / usual);
    MostLikely found = mostLikely(problem.dividedBy(std::exp(logarithm)), compared,
                                  control.between(done, std::min(1.0, done + 1.0 / usual)));
    found.evidence -= perLogarithm * logarithm;  // of the photographs as they are
    return tried.emplace(place, std::move(found)).first->second;
  };
  int best = 0;
  for (const int direction : {1, -1})
    while (std::abs(best) < most && at(best + direction).evidence > at(best).evidence) best += direction;
  const double below = at(best - 1).evidence, peak = at(best).evidence, above = at(best + 1).evidence;
  const double bend = std::max(2 * peak - below - above, 1e-3);
  const PixelProblem divided = problem.dividedBy(std::exp(start + best * step));
  ExposureEvidence result;
  result.logarithm = start + step * (best + std::clamp(0.5 * (above - below) / bend, -0.5, 0.5));
  result.slope = (at(best + 1).x - at(best - 1).x) / (2 * step);
  result.unexplainedSnr = photograph::unexplainedSnr(divided.data, divided.noise, divided.data - at(best).at.values);
  // The errors were 2.7 times larger (root of the mean square, 14 measured files, docs/results/photographs.md).
  constexpr double measured = 2.7;
  result.deviation = measured * std::max(1.0, widening(result.unexplainedSnr, images)) * step / std::sqrt(bend);
  result.atStart = std::move(tried.at(0));
  return result;
}

}  // namespace gonio::photograph
