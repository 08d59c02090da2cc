// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/fitting/fit_parameters.h"
#include "core/fitting/projected_problem.h"
#include "core/math/parallel.h"

/// The Jacobian of ProjectedProblem.
namespace gonio::fitting {

namespace {

/// Step of the difference quotients, in units: rounding and truncation both stay below 1e-7 of the derivative.
constexpr double differenceStep = 1e-6;

double stepFrom(double unit, const UnitScale& scale) {
  return unit + differenceStep <= scale.maximum() ? differenceStep : -differenceStep;
}

/// One channel's residuals linearised at its solution.
class Linearisation {
 public:
  Linearisation(const ChannelProblem& problem, const ChannelSolution& solution)
      : slopes_(Eigen::Index(problem.size())), columns_(slopes_.size(), Eigen::Index(problem.bases.size())) {
    problem.metric.visitDomain([&](const auto&, const auto& slope) {
      problem.metric.visitPower([&](const auto& reweight, const auto& powerSlope) {
        const double *factor = problem.factor.data(), *rootWeight = problem.rootWeight.data(),
                     *model = solution.model.data(), *differences = solution.differences.data();
        double* slopes = slopes_.data();
        for (std::size_t i = 0; i < problem.size(); ++i) {
          const double d = differences[i];
          slopes[i] = rootWeight[i] * (reweight(d) * powerSlope(d)) * slope(model[i] * factor[i]) * factor[i];
        }
      });
    });
    for (std::size_t j = 0; j < problem.bases.size(); ++j) {
      const double p = solution.parameters[Eigen::Index(j)];
      if (p > problem.lower[Eigen::Index(j)] && p < problem.upper[Eigen::Index(j)]) addColumn(problem.bases[j]);
    }
    columns_.conservativeResize(Eigen::NoChange, usedCount_);
    gram_.compute(columns_.transpose() * columns_);
  }

  /// Turns a change of the model into that of the residuals, without what the free linear parameters can undo.
  void apply(Eigen::VectorXd& column) const {
    column.array() *= slopes_;
    if (usedCount_ == 0) return;
    const LinearVector right = columns_.transpose() * column;
    column.noalias() -= columns_ * gram_.solve(right);
  }

 private:
  void addColumn(std::span<const double> basis) {
    auto column = columns_.col(usedCount_);
    column = slopes_ * Eigen::Map<const Eigen::ArrayXd>(basis.data(), slopes_.size());
    const double length = column.norm();
    if (!(length > 0)) return;
    column /= length;
    ++usedCount_;
  }

  Eigen::ArrayXd slopes_;
  LinearMatrix columns_;  ///< of the linear parameters off their bounds, unit length
  Eigen::Index usedCount_ = 0;
  Eigen::LDLT<LinearMatrix> gram_;
};

}  // namespace

/// How many unknowns from `first` on one evaluation can move, each in a channel of its own: with one fitted channel, as
/// many as there are channels; with several, the values of one parameter in different channels.
std::size_t ProjectedProblem::perturbedTogether(std::size_t first) const {
  std::size_t count = 1;
  while (count < 3 && first + count < unknowns_.size()) {
    const Unknown &a = unknowns_[first], &b = unknowns_[first + count];
    if (channels_.size() > 1 && (a.channel < 0 || b.parameter != a.parameter)) break;
    ++count;
  }
  return count;
}

/// The model with `count` unknowns from `first` on moved by their steps: see perturbedTogether().
std::vector<Rgb> ProjectedProblem::perturbedModel(std::size_t first, std::size_t count) const {
  std::vector<double> units = units_;
  if (channels_.size() > 1)
    for (std::size_t k = first; k < first + count; ++k) units[k] += stepFrom(units[k], unknowns_[k].scale);
  models::ParameterValues values = valuesAt(units);
  if (channels_.size() == 1)
    for (std::size_t m = 0; m < count; ++m) {
      const Unknown& u = unknowns_[first + m];
      const double unit = units_[first + m];
      values.values[u.parameter][int(m)] = u.scale.toValue(unit + stepFrom(unit, u.scale));
    }
  for (std::size_t j = 0; j < linear_.size(); ++j)
    for (std::size_t slot = 0; slot < channels_.size(); ++slot) {
      const double p = solutions_[slot].parameters[Eigen::Index(j)];
      if (channels_.size() == 1)
        values.values[linear_[j]] = Rgb(p);
      else
        values.values[linear_[j]][channels_[slot]] = p;
    }
  copyToTwins(model_.spec(), values, target_.cells.symmetry);
  std::vector<Rgb> result;
  evaluateModel(values, result);
  return result;
}

void ProjectedProblem::jacobian(double* out) const {
  const std::size_t cells = target_.cells.size(), unknowns = unknowns_.size();
  const double factor = preferenceFactor(units_);
  std::vector<ChannelProblem> problems;
  for (std::size_t slot = 0; slot < channels_.size(); ++slot) problems.push_back(channelProblem(slot));
  std::vector<std::optional<Linearisation>> linearisations(channels_.size());
  parallelForBlocks(channels_.size(), 1, [&](std::size_t slot, std::size_t) {
    linearisations[slot].emplace(problems[slot], solutions_[slot]);
  });
  Eigen::VectorXd column{Eigen::Index(cells)};
  for (std::size_t first = 0, count = 0; first < unknowns; first += count) {
    count = perturbedTogether(first);
    const std::vector<Rgb> perturbed = perturbedModel(first, count);
    for (std::size_t k = first; k < first + count; ++k) {
      const double step = stepFrom(units_[k], unknowns_[k].scale);
      const double slope = preference * (units_[k] - unknowns_[k].defaultUnit) / factor;
      for (std::size_t slot = 0; slot < channels_.size(); ++slot) {
        const int channel = channels_.size() == 1 ? int(k - first) : channels_[slot];
        const double *model = solutions_[slot].model.data(), *residuals = solutions_[slot].residuals.data();
        const bool isOfOtherChannel =
            channels_.size() > 1 && unknowns_[k].channel >= 0 && unknowns_[k].channel != channel;
        if (isOfOtherChannel) {
          column.setZero();
        } else {
          for (std::size_t i = 0; i < cells; ++i) column[Eigen::Index(i)] = (perturbed[i][channel] - model[i]) / step;
          linearisations[slot]->apply(column);
        }
        double* row = out + slot * cells * unknowns + k;
        for (std::size_t i = 0; i < cells; ++i)
          row[i * unknowns] = factor * column[Eigen::Index(i)] + slope * residuals[i];
      }
    }
  }
}

}  // namespace gonio::fitting
