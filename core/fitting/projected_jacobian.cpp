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
  return unit + differenceStep <= scale.highest() ? differenceStep : -differenceStep;
}

/// One channel's residuals linearised at its solution.
class Linearisation {
 public:
  Linearisation(const ChannelProblem& problem, const ChannelSolution& solution) : slopes_(problem.size()) {
    for (std::size_t i = 0; i < problem.size(); ++i) {
      const double x = solution.model[i] * problem.factor[i];
      const double d = problem.metric.transform(x) - problem.transformed[i];
      slopes_[i] = problem.rootWeight[i] * problem.metric.shapeSlope(d) * problem.metric.slope(x) * problem.factor[i];
    }
    for (std::size_t j = 0; j < problem.bases.size(); ++j) {
      const double p = solution.parameters[Eigen::Index(j)];
      if (p > problem.lower[Eigen::Index(j)] && p < problem.upper[Eigen::Index(j)]) addColumn(problem.bases[j]);
    }
    const Eigen::Index count = Eigen::Index(columns_.size());
    LinearMatrix gram(count, count);
    for (Eigen::Index a = 0; a < count; ++a)
      for (Eigen::Index b = 0; b < count; ++b) gram(a, b) = dot(columns_[a], columns_[b]);
    gram_.compute(gram);
  }

  /// Turns a change of the model into that of the residuals, without what the free linear parameters can undo.
  void apply(std::vector<double>& column) const {
    for (std::size_t i = 0; i < column.size(); ++i) column[i] *= slopes_[i];
    if (columns_.empty()) return;
    LinearVector right(Eigen::Index(columns_.size()));
    for (std::size_t a = 0; a < columns_.size(); ++a) right[Eigen::Index(a)] = dot(columns_[a], column);
    const LinearVector fractions = gram_.solve(right);
    for (std::size_t a = 0; a < columns_.size(); ++a)
      for (std::size_t i = 0; i < column.size(); ++i) column[i] -= fractions[Eigen::Index(a)] * columns_[a][i];
  }

 private:
  static double dot(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }

  void addColumn(std::span<const double> basis) {
    std::vector<double> column(slopes_);
    for (std::size_t i = 0; i < column.size(); ++i) column[i] *= basis[i];
    const double length = std::sqrt(dot(column, column));
    if (!(length > 0)) return;
    for (double& x : column) x /= length;
    columns_.push_back(std::move(column));
  }

  std::vector<double> slopes_;
  std::vector<std::vector<double>> columns_;  ///< of the linear parameters off their bounds, unit length
  Eigen::LDLT<LinearMatrix> gram_;
};

}  // namespace

/// The model with `count` unknowns from `first` on moved by their steps: all at once in one evaluation where each has
/// a channel of the evaluation to itself (one channel is fitted), else there is only one.
std::vector<Rgb> ProjectedProblem::perturbedModel(std::size_t first, std::size_t count) const {
  std::vector<double> units = units_;
  if (channels_.size() > 1) units[first] += stepFrom(units[first], unknowns_[first].scale);
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
  const std::size_t stride = channels_.size() == 1 ? 3 : 1;
  const double factor = preferenceFactor(units_);
  std::vector<ChannelProblem> problems;
  for (std::size_t slot = 0; slot < channels_.size(); ++slot) problems.push_back(channelProblem(slot));
  std::vector<std::optional<Linearisation>> linearisations(channels_.size());
  parallelForBlocks(channels_.size(), 1, [&](std::size_t slot, std::size_t) {
    linearisations[slot].emplace(problems[slot], solutions_[slot]);
  });
  std::vector<double> column(cells);
  for (std::size_t first = 0; first < unknowns; first += stride) {
    const std::size_t count = std::min(stride, unknowns - first);
    const std::vector<Rgb> perturbed = perturbedModel(first, count);
    for (std::size_t k = first; k < first + count; ++k) {
      const double step = stepFrom(units_[k], unknowns_[k].scale);
      const double slope = preference * (units_[k] - unknowns_[k].defaultUnit) / factor;
      for (std::size_t slot = 0; slot < channels_.size(); ++slot) {
        const int channel = channels_.size() == 1 ? int(k - first) : channels_[slot];
        for (std::size_t i = 0; i < cells; ++i) column[i] = (perturbed[i][channel] - solutions_[slot].model[i]) / step;
        linearisations[slot]->apply(column);
        double* row = out + slot * cells * unknowns + k;
        for (std::size_t i = 0; i < cells; ++i)
          row[i * unknowns] = factor * column[i] + slope * solutions_[slot].residuals[i];
      }
    }
  }
}

}  // namespace gonio::fitting
