// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/projected_problem.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/fitting/fit_parameters.h"
#include "core/math/parallel.h"

namespace gonio::fitting {

namespace {

/// Where a logarithmic range starts whose spec starts at 0.
constexpr double minFraction = 1e-4;

}  // namespace

UnitScale::UnitScale(const models::ParameterSpec& spec)
    : logarithmic_(spec.scale == models::ParameterScale::logarithmic), hardMin_(spec.hardMin), hardMax_(spec.hardMax) {
  const double softMin = logarithmic_ && !(spec.softMin > 0) ? spec.softMax * minFraction : spec.softMin;
  const auto scaled = [&](double value) { return logarithmic_ ? std::log(value) : value; };
  origin_ = scaled(softMin);
  extent_ = scaled(spec.softMax) - origin_;
  if (!(extent_ > 0)) extent_ = 1;
  const double hardMinimum = logarithmic_ && !(spec.hardMin > 0) ? softMin * minFraction : spec.hardMin;
  minimum_ = (scaled(hardMinimum) - origin_) / extent_;
  maximum_ = (scaled(spec.hardMax) - origin_) / extent_;
}

double UnitScale::toUnit(double value) const {
  if (logarithmic_ && !(value > 0)) return minimum_;
  return std::clamp(((logarithmic_ ? std::log(value) : value) - origin_) / extent_, minimum_, maximum_);
}

double UnitScale::toValue(double unit) const {
  const double scaled = origin_ + std::clamp(unit, minimum_, maximum_) * extent_;
  return std::clamp(logarithmic_ ? std::exp(scaled) : scaled, hardMin_, hardMax_);
}

namespace {

constexpr std::size_t evaluationBlock = 2048;

/// The linear parameter's value whose basis is evaluated.
double unitStrength(const models::ParameterSpec& spec) { return std::min(1.0, spec.hardMax); }

}  // namespace

FitTarget::FitTarget(FitCells fitCells, MetricTransform fitMetric, double linearCostTolerance)
    : cells(std::move(fitCells)), metric(fitMetric), costTolerance(linearCostTolerance) {
  double total = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double cosI = cells.cosI[i], cosO = cells.cosO[i];
    factor.push_back(metric.factor(cosI, cosO));
    rootWeight.push_back(cells.rootWeight[i] * std::sqrt(metric.weight(cosI, cosO)));
    total += rootWeight[i] * rootWeight[i];
  }
  if (total > 0)
    for (double& weight : rootWeight) weight /= std::sqrt(total);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    transformed[channel].resize(cells.size());
    startWeight[channel].resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double x = cells.values[channel][i] * factor[i];
      transformed[channel][i] = metric.transform(x);
      startWeight[channel][i] = rootWeight[i] * metric.slope(x) * factor[i];
    }
  }
}

ProjectedProblem::ProjectedProblem(const models::Model& model, const FitTarget& target,
                                   const models::ParameterValues& base, std::vector<std::size_t> freeParameters,
                                   std::vector<int> channels)
    : model_(model),
      target_(target),
      base_(base),
      channels_(std::move(channels)),
      sharesBases_(!model.spec().dependsOnWavelength),
      bestCost_(std::numeric_limits<double>::infinity()) {
  const std::span<const models::ParameterSpec> specs = model.spec().parameters;
  linear_ = parametersOf(model.spec(), base, FitRole::linear, target.cells.symmetry);
  // With channels fitted together, per-channel values outside the unknowns still make their bases differ.
  for (const std::size_t i : parametersOf(model.spec(), base, FitRole::nonlinear, target.cells.symmetry))
    if (specs[i].perChannel && channels_.size() > 1) sharesBases_ = false;
  for (const std::size_t parameter : freeParameters) {
    const UnitScale scale(specs[parameter]);
    const double unit = scale.toUnit(specs[parameter].defaultValue);
    if (specs[parameter].perChannel)
      for (const int channel : channels_) unknowns_.push_back({parameter, channel, scale, unit});
    else
      unknowns_.push_back({parameter, -1, scale, unit});
  }
  solutions_.resize(channels_.size());
  bases_.resize((sharesBases_ ? 1 : channels_.size()) * linear_.size());
}

std::vector<double> ProjectedProblem::unitsOf(const models::ParameterValues& values) const {
  std::vector<double> units;
  for (const Unknown& u : unknowns_)
    units.push_back(u.scale.toUnit(values.values[u.parameter][std::max(0, u.channel)]));
  return units;
}

/// Of one channel alone all channels get the values, so that the evaluation's three channels can do different work.
models::ParameterValues ProjectedProblem::valuesAt(std::span<const double> units) const {
  models::ParameterValues values = base_;
  for (std::size_t k = 0; k < unknowns_.size(); ++k) {
    const Unknown& u = unknowns_[k];
    const double value = u.scale.toValue(units[k]);
    if (u.channel < 0 || channels_.size() == 1)
      values.values[u.parameter] = Rgb(value);
    else
      values.values[u.parameter][u.channel] = value;
  }
  if (channels_.size() == 1)
    for (Rgb& value : values.values) {
      const std::size_t parameter = std::size_t(&value - values.values.data());
      const bool isUnknown =
          std::any_of(unknowns_.begin(), unknowns_.end(), [&](const Unknown& u) { return u.parameter == parameter; });
      if (!isUnknown) value = Rgb(value[channels_[0]]);
    }
  copyToTwins(model_.spec(), values, target_.cells.symmetry);
  return values;
}

void ProjectedProblem::evaluateModel(const models::ParameterValues& values, std::vector<Rgb>& result) const {
  const std::unique_ptr<const Brdf> brdf = model_.instantiateUnclamped(values);
  const std::span<const DirectionPair> pairs = target_.cells.pairs;
  result.resize(pairs.size());
  parallelForBlocks(pairs.size(), evaluationBlock, [&](std::size_t begin, std::size_t end) {
    brdf->evaluate(pairs.subspan(begin, end - begin), std::span(result).subspan(begin, end - begin));
  });
}

void ProjectedProblem::evaluateBases(const models::ParameterValues& at) {
  const std::span<const models::ParameterSpec> specs = model_.spec().parameters;
  models::ParameterValues values = at;
  std::vector<Rgb> result;
  // Shared bases: three of them a time, one in each channel. Else one a time, for all channels.
  const std::size_t stride = sharesBases_ ? 3 : 1;
  for (std::size_t first = 0; first < linear_.size(); first += stride) {
    const std::size_t last = std::min(first + stride, linear_.size());
    for (const std::size_t parameter : linear_) values.values[parameter] = Rgb(0);
    for (std::size_t j = first; j < last; ++j) {
      Rgb& value = values.values[linear_[j]];
      if (sharesBases_)
        value[int(j - first)] = unitStrength(specs[linear_[j]]);
      else
        value = Rgb(unitStrength(specs[linear_[j]]));
    }
    evaluateModel(values, result);
    for (std::size_t j = first; j < last; ++j)
      for (std::size_t slot = 0; slot < (sharesBases_ ? 1 : channels_.size()); ++slot) {
        const int channel = sharesBases_ ? int(j - first) : channels_[slot];
        std::vector<double>& column = bases_[slot * linear_.size() + j];
        column.resize(result.size());
        const double scale = 1 / unitStrength(specs[linear_[j]]);
        for (std::size_t i = 0; i < result.size(); ++i) column[i] = result[i][channel] * scale;
      }
  }
}

ChannelProblem ProjectedProblem::channelProblem(std::size_t slot) const {
  const std::size_t channel = std::size_t(channels_[slot]);
  ChannelProblem problem{.metric = target_.metric,
                         .factor = target_.factor,
                         .rootWeight = target_.rootWeight,
                         .transformed = target_.transformed[channel],
                         .startWeight = target_.startWeight[channel],
                         .values = target_.cells.values[channel],
                         .bases = {},
                         .lower = LinearVector(Eigen::Index(linear_.size())),
                         .upper = LinearVector(Eigen::Index(linear_.size())),
                         .costTolerance = target_.costTolerance};
  for (std::size_t j = 0; j < linear_.size(); ++j) {
    problem.bases.emplace_back(basis(slot, j));
    problem.lower[Eigen::Index(j)] = model_.spec().parameters[linear_[j]].hardMin;
    problem.upper[Eigen::Index(j)] = model_.spec().parameters[linear_[j]].hardMax;
  }
  return problem;
}

double ProjectedProblem::preferenceFactor(std::span<const double> units) const {
  double square = 0;
  for (std::size_t k = 0; k < unknowns_.size(); ++k) {
    const double distance = units[k] - unknowns_[k].defaultUnit;
    square += distance * distance;
  }
  return std::sqrt(1 + preference * square);
}

double ProjectedProblem::cost(std::span<const double> units) {
  units_.assign(units.begin(), units.end());
  evaluateBases(valuesAt(units));
  parallelForBlocks(channels_.size(), 1, [&](std::size_t slot, std::size_t) {
    solutions_[slot] = solveLinearParameters(channelProblem(slot), solutions_[slot].parameters);
  });
  const double factor = preferenceFactor(units_);
  double total = 0;
  for (const ChannelSolution& solution : solutions_) total += solution.cost;
  total *= factor * factor;
  if (total < bestCost_) {
    bestCost_ = total;
    bestUnits_ = units_;
    bestLinear_.clear();
    for (const ChannelSolution& solution : solutions_) bestLinear_.push_back(solution.parameters);
  }
  return total;
}

void ProjectedProblem::residuals(double* out) const {
  const double factor = preferenceFactor(units_);
  for (const ChannelSolution& solution : solutions_)
    for (const double residual : solution.residuals) *out++ = factor * residual;
}

models::ParameterValues ProjectedProblem::bestParameters() const {
  models::ParameterValues values = base_;
  if (bestUnits_.empty() && !unknowns_.empty()) return values;
  const models::ParameterValues at = valuesAt(bestUnits_);
  for (const Unknown& u : unknowns_) {
    if (u.channel < 0)
      values.values[u.parameter] = at.values[u.parameter];
    else
      values.values[u.parameter][u.channel] = at.values[u.parameter][u.channel];
  }
  for (std::size_t slot = 0; slot < bestLinear_.size(); ++slot)
    for (std::size_t j = 0; j < linear_.size(); ++j)
      values.values[linear_[j]][channels_[slot]] = bestLinear_[slot][Eigen::Index(j)];
  copyToTwins(model_.spec(), values, target_.cells.symmetry);
  return values;
}

// The Jacobian.

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
