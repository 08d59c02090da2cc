// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit.h"

#include <algorithm>
#include <chrono>

#include "core/fitting/fit_data.h"
#include "core/fitting/fit_parameters.h"
#include "core/fitting/group_fit.h"
#include "core/math/parallel.h"

namespace gonio::fitting {

namespace {

constexpr double preparationFraction = 0.05, errorsFraction = 0.05;

/// Channels that are fitted together: all, or each alone where the model has no shared parameter to tie them.
std::vector<std::vector<int>> channelGroups(const models::ModelSpec& spec, const models::ParameterValues& base,
                                            DataSymmetry symmetry) {
  const std::vector<std::size_t> nonlinear = parametersOf(spec, base, FitRole::nonlinear, symmetry);
  const bool allPerChannel =
      std::ranges::all_of(nonlinear, [&](std::size_t i) { return spec.parameters[i].perChannel; });
  if (!nonlinear.empty() && allPerChannel) return {{0}, {1}, {2}};
  return {{0, 1, 2}};
}

/// The choices asked for, the defaults, and black: what is left as it is where there is nothing to fit.
models::ParameterValues baseParameters(const models::ModelSpec& spec, const models::ParameterValues& choices) {
  models::ParameterValues values = models::defaultParameters(spec);
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    if (spec.parameters[i].linear) values.values[i] = Rgb(std::max(0.0, spec.parameters[i].hardMin));
    if (!spec.parameters[i].choices.empty() && !choices.values.empty()) values.values[i] = choices.values[i];
  }
  return values;
}

bool isBlack(const FitCells& cells, const std::vector<int>& channels) {
  return std::all_of(channels.begin(), channels.end(), [&](int channel) {
    const std::vector<double>& values = cells.values[std::size_t(channel)];
    return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
  });
}

models::ParameterValues fitParameters(const FitData& data, const models::Model& model,
                                      const models::ParameterValues& base, const std::stop_token& stop,
                                      ProgressMeter& progress) {
  models::ParameterValues parameters = base;
  if (data.usedCells() == 0) return parameters;
  const FitTarget& search = data.search();
  const FitTarget& polish = data.polish(parametersOf(model.spec(), base, FitRole::nonlinear, data.symmetry()).size());
  progress.add(preparationFraction);
  const std::vector<std::vector<int>> groups = channelGroups(model.spec(), base, data.symmetry());
  std::vector<models::ParameterValues> fitted(groups.size(), base);
  const double fraction = (1 - preparationFraction - errorsFraction) / double(groups.size());
  parallelForBlocks(groups.size(), 1, [&](std::size_t g, std::size_t) {
    if (!isBlack(polish.cells, groups[g]))
      fitted[g] = fitGroup(model, search, polish, base, groups[g], stop, progress, fraction);
  });
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t i = 0; i < parameters.values.size(); ++i)
      for (const int channel : groups[g]) parameters.values[i][channel] = fitted[g].values[i][channel];
  return parameters;
}

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// By which share a lobe more has to lower the error: less is not worth its parameters.
constexpr double worthwhile = 0.05;

FitResult fitWithChoices(const FitData& data, const models::Model& model, const TaskControl& control,
                         const models::ParameterValues& choices) {
  const auto start = Clock::now();
  ProgressMeter progress(control);
  FitResult result;
  result.model = &model;
  result.usedCells = data.usedCells();
  result.invalidCells = data.invalidCells();
  result.grazingCells = data.grazingCells();
  result.warnings = data.warnings();
  result.parameters =
      model.canonical(fitParameters(data, model, baseParameters(model.spec(), choices), control.stop, progress));
  result.cancelled = control.stop.stop_requested();
  result.errors = data.errors(*model.instantiate(result.parameters));
  progress.add(1);
  result.seconds = secondsSince(start);
  return result;
}

/// From one lobe on, as many as lower the error.
FitResult fitFewestLobes(const FitData& data, const models::Model& model, const std::vector<std::size_t>& optional,
                         const TaskControl& control) {
  const auto metric = std::size_t(data.options().metric);
  const double trials = double(optional.size()) + 1;
  FitResult best;
  double seconds = 0;
  for (std::size_t count = 0; count <= optional.size(); ++count) {
    models::ParameterValues choices = models::defaultParameters(model.spec());
    for (std::size_t k = 0; k + count < optional.size(); ++k) {
      const double other = 1 - choices.values[optional[k]].x;
      choices.values[optional[k]] = Rgb(other);
    }
    FitResult result =
        fitWithChoices(data, model, control.between(double(count) / trials, double(count + 1) / trials), choices);
    seconds += result.seconds;
    const bool better = count == 0 || result.errors[metric] < (1 - worthwhile) * best.errors[metric];
    const bool cancelled = result.cancelled;
    if (better) best = std::move(result);
    best.cancelled = cancelled;
    if (!better || cancelled) break;
  }
  control.report(1);
  best.seconds = seconds;
  return best;
}

}  // namespace

FitResult fit(const FitData& data, const models::Model& model, const TaskControl& control,
              const models::ParameterValues& choices) {
  const std::vector<std::size_t> optional = optionalLobes(model.spec());
  return optional.empty() || !choices.values.empty() ? fitWithChoices(data, model, control, choices)
                                                     : fitFewestLobes(data, model, optional, control);
}

FitResult fit(const Brdf& base, const models::Model& model, const FitOptions& options, const TaskControl& control,
              const models::ParameterValues& choices) {
  const auto start = Clock::now();
  FitResult result = fit(FitData(base, options), model, control, choices);
  result.seconds = secondsSince(start);
  return result;
}

FitResult fit(const FitBase& base, const models::Model& model, const FitOptions& options, const TaskControl& control,
              const models::ParameterValues& choices) {
  const auto start = Clock::now();
  FitResult result = fit(FitData(*base.fitted, *base.measurement, options), model, control, choices);
  result.seconds = secondsSince(start);
  return result;
}

}  // namespace gonio::fitting
