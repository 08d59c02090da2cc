// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/linear_solve.h"

#include <algorithm>
#include <cmath>

namespace gonio::fitting {

namespace {

constexpr int maxSteps = 50;
constexpr int maxHalvings = 12;
constexpr double stepTolerance = 1e-9;  ///< of each parameter, relative: Gauss-Newton's next error is its square

constexpr std::size_t blockSize = 512;  ///< cells at a time: their arrays stay in the first caches

using Cells = Eigen::Map<const Eigen::ArrayXd>;
Cells cellsOf(std::span<const double> values, std::size_t begin, std::size_t count) {
  return {values.data() + begin, Eigen::Index(count)};
}

/// Gauss-Newton's bounded linear problem: the basis columns times some slopes against a target, block by block.
class GaussNewtonProblem {
 public:
  explicit GaussNewtonProblem(const ChannelProblem& problem)
      : problem_(problem),
        columns_(Eigen::Index(blockSize), Eigen::Index(problem.bases.size())),
        normal_(LinearMatrix::Zero(columns_.cols(), columns_.cols())),
        right_(LinearVector::Zero(columns_.cols())) {}

  /// @param slopes, target of `count` cells from `begin` on.
  void add(std::size_t begin, std::size_t count, const double* slopes, const double* target) {
    const auto rows = Eigen::Index(count);
    const Eigen::Map<const Eigen::ArrayXd> rowWeights(slopes, rows);
    for (Eigen::Index a = 0; a < columns_.cols(); ++a) {
      columns_.col(a).head(rows) = rowWeights * cellsOf(problem_.bases[std::size_t(a)], begin, count);
      right_[a] += columns_.col(a).head(rows).dot(Eigen::Map<const Eigen::VectorXd>(target, rows));
      for (Eigen::Index b = 0; b <= a; ++b) normal_(a, b) += columns_.col(a).head(rows).dot(columns_.col(b).head(rows));
    }
  }
  LinearVector solution() const {
    return solveBounded(normal_.selfadjointView<Eigen::Lower>(), right_, problem_.lower, problem_.upper);
  }

 private:
  const ChannelProblem& problem_;
  LinearMatrix columns_, normal_;
  LinearVector right_;
};

template <typename Work>
void forBlocks(std::size_t size, const Work& work) {
  for (std::size_t begin = 0; begin < size; begin += blockSize) work(begin, std::min(blockSize, size - begin));
}

/// The model, the residuals and the cost at the solution's parameters.
void evaluate(const ChannelProblem& problem, ChannelSolution& solution) {
  solution.model.resize(problem.size());
  solution.differences.resize(problem.size());
  solution.residuals.resize(problem.size());
  solution.cost = 0;
  const auto evaluateBlock = [&](std::size_t begin, std::size_t count, const auto& transform, const auto& reweight) {
    double* model = solution.model.data() + begin;
    problem.evaluateModel(solution.parameters, begin, {model, count});
    double *differences = solution.differences.data() + begin, *residuals = solution.residuals.data() + begin;
    const double *factor = problem.factor.data() + begin, *transformed = problem.transformed.data() + begin,
                 *rootWeight = problem.rootWeight.data() + begin;
    for (std::size_t i = 0; i < count; ++i) {
      const double d = transform(model[i] * factor[i]) - transformed[i];
      differences[i] = d;
      residuals[i] = rootWeight[i] * (d * reweight(d));
    }
    solution.cost += cellsOf(solution.residuals, begin, count).square().sum();
  };
  problem.metric.visitDomain([&](const auto& transform, const auto&) {
    problem.metric.visitPower([&](const auto& reweight, const auto&) {
      forBlocks(problem.size(),
                [&](std::size_t begin, std::size_t count) { evaluateBlock(begin, count, transform, reweight); });
    });
  });
}

/// The linear problem with the transform replaced by its tangent at the measurement.
LinearVector startParameters(const ChannelProblem& problem) {
  GaussNewtonProblem equations(problem);
  Eigen::ArrayXd target(static_cast<Eigen::Index>(blockSize));
  forBlocks(problem.size(), [&](std::size_t begin, std::size_t count) {
    const Cells weights = cellsOf(problem.startWeight, begin, count);
    target.head(Eigen::Index(count)) = weights * cellsOf(problem.values, begin, count);
    equations.add(begin, count, weights.data(), target.data());
  });
  return equations.solution();
}

/// Where one Gauss-Newton step (reweighted for the means of |d|^p) would go.
LinearVector gaussNewtonTarget(const ChannelProblem& problem, const ChannelSolution& at) {
  GaussNewtonProblem equations(problem);
  double slopes[blockSize], target[blockSize];
  const auto addBlock = [&](std::size_t begin, std::size_t count, const auto& slope, const auto& reweight) {
    const double *factor = problem.factor.data() + begin, *rootWeight = problem.rootWeight.data() + begin,
                 *model = at.model.data() + begin, *differences = at.differences.data() + begin,
                 *residuals = at.residuals.data() + begin;
    for (std::size_t i = 0; i < count; ++i) {
      slopes[i] = rootWeight[i] * reweight(differences[i]) * slope(model[i] * factor[i]) * factor[i];
      target[i] = slopes[i] * model[i] - residuals[i];
    }
    equations.add(begin, count, slopes, target);
  };
  problem.metric.visitDomain([&](const auto&, const auto& slope) {
    problem.metric.visitPower([&](const auto& reweight, const auto&) {
      forBlocks(problem.size(), [&](std::size_t begin, std::size_t count) { addBlock(begin, count, slope, reweight); });
    });
  });
  return equations.solution();
}

}  // namespace

void ChannelProblem::evaluateModel(const LinearVector& p, std::size_t begin, std::span<double> sums) const {
  std::fill(sums.begin(), sums.end(), 0.0);
  for (std::size_t j = 0; j < bases.size(); ++j) {
    const double fraction = p[Eigen::Index(j)];
    if (fraction == 0) continue;
    const double* basis = bases[j].data() + begin;
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += fraction * basis[i];
  }
}

std::vector<double> ChannelProblem::model(const LinearVector& p) const {
  std::vector<double> sums(size());
  evaluateModel(p, 0, sums);
  return sums;
}

ChannelSolution solveLinearParameters(const ChannelProblem& problem, const LinearVector& guess) {
  ChannelSolution best, trial;
  best.parameters = guess.size() == Eigen::Index(problem.bases.size()) ? guess : startParameters(problem);
  evaluate(problem, best);
  for (int step = 0; step < maxSteps && best.parameters.size() > 0; ++step) {
    const LinearVector from = best.parameters, to = gaussNewtonTarget(problem, best);
    if (((to - from).array().abs() <= stepTolerance * to.array().abs()).all()) break;
    const double costBefore = best.cost;
    double fraction = 1;
    for (int halving = 0; halving <= maxHalvings; ++halving, fraction /= 2) {
      trial.parameters = from + fraction * (to - from);
      evaluate(problem, trial);
      if (trial.cost < best.cost) break;
    }
    if (!(trial.cost < best.cost)) break;
    std::swap(best, trial);
    if (best.cost >= (1 - problem.costTolerance) * costBefore) break;
  }
  return best;
}

}  // namespace gonio::fitting
