// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <string>

#include "core/fitting/fit_data.h"
#include "core/fitting/fit_parameters.h"
#include "core/fitting/group_fit.h"
#include "core/math/parallel.h"
#include "core/math/sampling.h"

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

/// To three digits.
std::string threeDigits(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3g", value);
  return digits;
}

/// What the fit made of channels with the same value in all cells: its own values at directions spread over those that
/// count. Models without a constant term cannot reproduce them.
void describeConstants(const FitData& data, const Brdf& fitted, std::vector<std::string>& warnings) {
  if (std::ranges::none_of(data.constants(), [](const auto& constant) { return constant.has_value(); })) return;
  constexpr std::uint32_t count = 4096;
  std::vector<DirectionPair> pairs;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec2 u = scrambledSobol(i, 41), v = scrambledSobol(i, 42);
    const double most = data.options().maxPolarAngle;
    pairs.push_back({fromSpherical(most * u.x, 2 * pi * u.y), fromSpherical(most * v.x, 2 * pi * v.y)});
  }
  std::vector<Rgb> values(pairs.size());
  fitted.evaluate(pairs, values);
  for (int channel = 0; channel < 3; ++channel) {
    const std::optional<double>& constant = data.constants()[std::size_t(channel)];
    if (!constant) continue;
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Rgb& value : values) {
      least = std::min(least, value[channel]);
      most = std::max(most, value[channel]);
    }
    const std::string low = threeDigits(least), high = threeDigits(most), given = threeDigits(*constant);
    warnings.push_back(
        "All cells have the same value in " + std::string(channelNames[std::size_t(channel)]) + ", " + given +
        " 1/sr; the fit has " +
        (low == high ? (low == given ? "the same value" : low + " 1/sr") : low + " to " + high + " 1/sr") + ".");
  }
}

/// Linear parameters at the upper limit of their range: the measurement is probably brighter than the model can be.
void describeLimits(const models::ModelSpec& spec, const models::ParameterValues& values,
                    std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const models::ParameterSpec& parameter = spec.parameters[i];
    if (!parameter.linear || maxChannel(values.values[i]) < parameter.hardMax) continue;
    std::string names;
    for (int channel = 0; channel < 3; ++channel)
      if (values.values[i][channel] >= parameter.hardMax)
        names += (names.empty() ? "" : ", ") + std::string(channelNames[std::size_t(channel)]);
    warnings.push_back("The parameter " + std::string(parameter.id) + " is at its maximum, " +
                       threeDigits(parameter.hardMax) + ", in " + names +
                       ": the measurement is brighter than the model.");
  }
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
  const auto fitted = model.instantiate(result.parameters);
  describeConstants(data, *fitted, result.warnings);
  describeLimits(model.spec(), result.parameters, result.warnings);
  result.errors = data.errors(*fitted);
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
