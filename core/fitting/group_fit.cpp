// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/group_fit.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <stop_token>

#include "core/fitting/fit_parameters.h"
#include "core/fitting/projected_problem.h"
#include "core/math/parallel.h"

namespace gonio::fitting {

namespace {

struct SolveOptions {
  int maxIterations = 30;
  double functionTolerance = 1e-6;  ///< relative change of the cost at which the search stops
};

class ProjectedCost final : public ceres::CostFunction {
 public:
  explicit ProjectedCost(ProjectedProblem& problem) : problem_(problem) {
    set_num_residuals(problem.residualCount());
    mutable_parameter_block_sizes()->push_back(problem.unknownCount());
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const std::span<const double> units(parameters[0], std::size_t(problem_.unknownCount()));
    // Ceres asks for the Jacobian at the point it evaluated last: the linear parameters are known there.
    if (!std::equal(units.begin(), units.end(), last_.begin(), last_.end())) {
      problem_.cost(units);
      last_.assign(units.begin(), units.end());
    }
    problem_.residuals(residuals);
    if (jacobians && jacobians[0]) problem_.jacobian(jacobians[0]);
    return true;
  }

 private:
  ProjectedProblem& problem_;
  mutable std::vector<double> last_;
};

class Watcher final : public ceres::IterationCallback {
 public:
  Watcher(const std::stop_token& stop, const std::function<void()>& iterationDone)
      : stop_(stop), iterationDone_(iterationDone) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    if (iterationDone_) iterationDone_();
    return stop_.stop_requested() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const std::stop_token& stop_;
  const std::function<void()>& iterationDone_;
};

/// Minimises the problem's cost from `start` (in units of UnitScale) within the hard ranges, by Ceres' trust-region
/// Levenberg-Marquardt method. The result is problem.bestParameters(), never worse than the start. A stop request ends
/// it early. @param iterationDone called after each iteration.
void minimise(ProjectedProblem& problem, std::vector<double> start, const SolveOptions& options,
              const std::stop_token& stop, const std::function<void()>& iterationDone) {
  if (problem.unknownCount() == 0) {
    problem.cost({});
    return;
  }
  ProjectedCost cost(problem);
  Watcher watcher(stop, iterationDone);
  ceres::Problem::Options problemOptions;
  problemOptions.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem ceresProblem(problemOptions);
  for (int k = 0; k < problem.unknownCount(); ++k)
    start[k] = std::clamp(start[k], problem.scale(k).minimum(), problem.scale(k).maximum());
  ceresProblem.AddResidualBlock(&cost, nullptr, start.data());
  for (int k = 0; k < problem.unknownCount(); ++k) {
    ceresProblem.SetParameterLowerBound(start.data(), k, problem.scale(k).minimum());
    ceresProblem.SetParameterUpperBound(start.data(), k, problem.scale(k).maximum());
  }
  ceres::Solver::Options solverOptions;
  solverOptions.linear_solver_type = ceres::DENSE_QR;
  solverOptions.dense_linear_algebra_library_type = ceres::EIGEN;
  solverOptions.num_threads = 1;
  solverOptions.max_num_iterations = options.maxIterations;
  solverOptions.function_tolerance = options.functionTolerance;
  solverOptions.parameter_tolerance = 1e-9;
  solverOptions.gradient_tolerance = 0;
  solverOptions.logging_type = ceres::SILENT;
  solverOptions.callbacks = {&watcher};
  ceres::Solver::Summary summary;
  ceres::Solve(solverOptions, &ceresProblem, &summary);
}

constexpr std::size_t startsPerDimension = 24, maxStarts = 64;
constexpr std::size_t refinedStarts = 3;
/// Starts closer than this (units, largest coordinate) lead to the same minimum.
constexpr double sameStart = 0.12;
constexpr SolveOptions searchOptions{.maxIterations = 20, .functionTolerance = 1e-4};
constexpr SolveOptions polishOptions{.maxIterations = 40, .functionTolerance = 1e-6};

constexpr double startsFraction = 0.25, searchFraction = 0.35, finalistsFraction = 0.05, polishFraction = 0.35;

struct Candidate {
  models::ParameterValues parameters;
  std::vector<double> units;
  double cost = std::numeric_limits<double>::infinity();
};

/// Radical inverse (Halton 1960): fills [0, 1] evenly for any number of points.
double halton(std::size_t index, int base) {
  double result = 0, digit = 1;
  for (; index > 0; index /= std::size_t(base)) {
    digit /= base;
    result += digit * double(index % std::size_t(base));
  }
  return result;
}

bool isNear(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest < sameStart;
}

/// The cheapest candidates that are apart from each other; the first wins among equals.
std::vector<Candidate> selectDistinct(std::vector<Candidate> candidates, std::size_t count) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::vector<Candidate> selected;
  for (Candidate& candidate : candidates) {
    if (selected.size() == count) break;
    const bool isNew = std::none_of(selected.begin(), selected.end(),
                                    [&](const Candidate& other) { return isNear(candidate.units, other.units); });
    if (isNew) selected.push_back(std::move(candidate));
  }
  return selected;
}

class GroupFit {
 public:
  GroupFit(const models::Model& model, const std::vector<int>& channels, const std::stop_token& stop,
           ProgressMeter& progress, double fraction)
      : model_(model), channels_(channels), stop_(stop), progress_(progress), share_(fraction) {}

  /// The cost of each start; when stopped, of the first at least.
  std::vector<Candidate> rate(const FitTarget& target, const std::vector<models::ParameterValues>& starts,
                              const std::vector<std::size_t>& free, double fraction) {
    std::vector<Candidate> candidates(starts.size());
    parallelForBlocks(starts.size(), 1, [&](std::size_t s, std::size_t) {
      if (s > 0 && stop_.stop_requested()) return;
      ProjectedProblem problem(model_, target, starts[s], free, channels_);
      candidates[s].units = problem.unitsOf(starts[s]);
      candidates[s].cost = problem.cost(candidates[s].units);
      candidates[s].parameters = problem.bestParameters();
      progress_.add(share_ * fraction / double(starts.size()));
    });
    return candidates;
  }

  /// Runs the solver from each candidate; never returns a worse one.
  void refine(const FitTarget& target, std::vector<Candidate>& candidates, const std::vector<std::size_t>& free,
              const SolveOptions& options, double fraction) {
    parallelForBlocks(candidates.size(), 1, [&](std::size_t c, std::size_t) {
      double left = share_ * fraction / double(candidates.size());
      const double step = left / (options.maxIterations + 1);
      if (!stop_.stop_requested()) {
        ProjectedProblem problem(model_, target, candidates[c].parameters, free, channels_);
        minimise(problem, problem.unitsOf(candidates[c].parameters), options, stop_, [&] {
          progress_.add(std::min(step, left));
          left -= std::min(step, left);
        });
        candidates[c].cost = problem.bestCost();
        candidates[c].parameters = problem.bestParameters();
        candidates[c].units = problem.unitsOf(candidates[c].parameters);
      }
      progress_.add(left);
    });
  }

 private:
  const models::Model& model_;
  const std::vector<int>& channels_;
  const std::stop_token& stop_;
  ProgressMeter& progress_;
  double share_;
};

const Candidate& cheapest(const std::vector<Candidate>& candidates) {
  return *std::min_element(candidates.begin(), candidates.end(),
                           [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
}

/// Only the values that were fitted, so that groups of channels can be merged.
models::ParameterValues merged(const models::ModelSpec& spec, models::ParameterValues base,
                               const models::ParameterValues& fitted, const std::vector<int>& channels) {
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    if (!spec.parameters[i].perChannel)
      base.values[i] = fitted.values[i];
    else
      for (const int channel : channels) base.values[i][channel] = fitted.values[i][channel];
  }
  return base;
}

}  // namespace

std::vector<models::ParameterValues> startingPoints(const models::Model& model, const models::ParameterValues& base,
                                                    const std::vector<std::size_t>& free) {
  constexpr int primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
  std::vector<models::ParameterValues> starts{base};
  const std::size_t count = std::min(maxStarts, startsPerDimension * free.size());
  for (std::size_t s = 1; s <= count; ++s) {
    models::ParameterValues values = base;
    for (std::size_t d = 0; d < free.size(); ++d) {
      const UnitScale scale(model.spec().parameters[free[d]]);
      values.values[free[d]] = Rgb(scale.toValue(halton(s, primes[d % std::size(primes)])));
    }
    starts.push_back(std::move(values));
  }
  return starts;
}

std::vector<models::ParameterValues> grainStarts(const models::ModelSpec& spec, const models::ParameterValues& about) {
  constexpr double stretches[] = {0.06, 0.15};  // units to either side of the mean
  constexpr int directions = 8;
  std::vector<models::ParameterValues> starts;
  for (std::size_t r = 0; r < spec.parameters.size(); ++r) {
    if (!spec.parameters[r].anisotropicOnly) continue;
    for (const double stretch : stretches)
      for (int direction = 0; direction < directions; ++direction) {
        models::ParameterValues values = about;
        values.values[r] = Rgb(pi * (double(direction) / directions - 0.5));
        for (std::size_t y = 0; y < spec.parameters.size(); ++y)
          if (const auto x = spec.find(spec.parameters[y].isotropicTwin)) {
            const UnitScale scale(spec.parameters[y]);
            const double middle = (scale.toUnit(about.values[*x].x) + scale.toUnit(about.values[y].x)) / 2;
            values.values[*x] = Rgb(scale.toValue(middle - stretch));
            values.values[y] = Rgb(scale.toValue(middle + stretch));
          }
        starts.push_back(std::move(values));
      }
  }
  return starts;
}

void ProgressMeter::add(double fraction) {
  const std::lock_guard lock(mutex_);
  done_ = std::min(1.0, done_ + std::max(0.0, fraction));
  control_.report(done_);
}

models::ParameterValues fitGroup(const models::Model& model, const FitTarget& search, const FitTarget& polish,
                                 const models::ParameterValues& base, const std::vector<int>& channels,
                                 const std::stop_token& stop, ProgressMeter& progress, double fraction) {
  const DataSymmetry symmetry = search.cells.symmetry;
  const std::vector<std::size_t> all = parametersOf(model.spec(), base, FitRole::nonlinear, symmetry);
  std::vector<std::size_t> early;
  for (const std::size_t i : all)
    if (model.spec().parameters[i].group != models::ParameterGroup::shadowing) early.push_back(i);
  const bool isStaged = early.size() < all.size();
  GroupFit group(model, channels, stop, progress, fraction);
  std::vector<Candidate> rated = group.rate(search, startingPoints(model, base, early), early, startsFraction);
  if (symmetry == DataSymmetry::anisotropic)
    std::ranges::move(group.rate(search, grainStarts(model.spec(), cheapest(rated).parameters), early, 0),
                      std::back_inserter(rated));
  std::vector<Candidate> candidates = selectDistinct(std::move(rated), refinedStarts);
  std::vector<models::ParameterValues> finalists{base, candidates[0].parameters};
  group.refine(search, candidates, early, searchOptions, isStaged ? searchFraction / 2 : searchFraction);
  if (isStaged) {
    candidates = selectDistinct(std::move(candidates), 2);
    group.refine(search, candidates, all, searchOptions, searchFraction / 2);
  }
  // What is best on few cells need not be on many.
  for (const Candidate& candidate : candidates) finalists.push_back(candidate.parameters);
  std::vector<Candidate> best{cheapest(group.rate(polish, finalists, all, finalistsFraction))};
  group.refine(polish, best, all, polishOptions, polishFraction);
  return merged(model.spec(), base, best[0].parameters, channels);
}

}  // namespace gonio::fitting
