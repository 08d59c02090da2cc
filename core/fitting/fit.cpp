// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit.h"

#include <algorithm>
#include <chrono>

#include "core/fitting/group_fit.h"
#include "core/math/parallel.h"

namespace gonio::fitting {

namespace {

/// Patches of a theta_h row: about 3,000 cells of a MERL table find the minimum, the others settle it.
struct Strata {
  int thetaD, phiD;
};
constexpr Strata searchStrata{8, 5};
constexpr Strata fineStrata{18, 18};    ///< about 20,000 cells: models with few parameters
constexpr Strata coarseStrata{14, 10};  ///< about 10,000: evaluations of the others are many and dear
constexpr std::size_t fewParameters = 3;

constexpr double preparationShare = 0.05, errorsShare = 0.05;

/// Channels that are fitted together: all, or each alone where the model has no shared parameter to tie them.
std::vector<std::vector<int>> channelGroups(const models::ModelSpec& spec) {
  bool anyNonlinear = false, allPerChannel = true;
  for (const models::ParameterSpec& parameter : spec.parameters) {
    if (!isNonlinear(parameter)) continue;
    anyNonlinear = true;
    allPerChannel = allPerChannel && parameter.perChannel;
  }
  if (anyNonlinear && allPerChannel) return {{0}, {1}, {2}};
  return {{0, 1, 2}};
}

std::size_t nonlinearCount(const models::ModelSpec& spec) {
  return std::size_t(std::count_if(spec.parameters.begin(), spec.parameters.end(), isNonlinear));
}

/// The defaults, and black: what is left as it is where there is nothing to fit.
models::ParameterValues blackParameters(const models::ModelSpec& spec) {
  models::ParameterValues values = models::defaultParameters(spec);
  for (std::size_t i = 0; i < spec.parameters.size(); ++i)
    if (spec.parameters[i].linear) values.values[i] = Rgb(std::max(0.0, spec.parameters[i].hardMin));
  return values;
}

bool isBlack(const FitCells& cells, const std::vector<int>& channels) {
  return std::all_of(channels.begin(), channels.end(), [&](int channel) {
    const std::vector<double>& values = cells.values[std::size_t(channel)];
    return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
  });
}

models::ParameterValues fitParameters(const TabulatedBrdf& table, const models::Model& model, const FitOptions& options,
                                      const CellCensus& census, const std::stop_token& stop, ProgressMeter& progress) {
  models::ParameterValues parameters = blackParameters(model.spec());
  if (census.used == 0) return parameters;
  const Strata strata = nonlinearCount(model.spec()) <= fewParameters ? fineStrata : coarseStrata;
  const MetricTransform metric(options.metric, options.gamma);
  const FitTarget search(stratifiedCells(table, census, searchStrata.thetaD, searchStrata.phiD), metric);
  const FitTarget polish(stratifiedCells(table, census, strata.thetaD, strata.phiD), metric);
  progress.add(preparationShare);
  const std::vector<std::vector<int>> groups = channelGroups(model.spec());
  const models::ParameterValues base = parameters;
  std::vector<models::ParameterValues> fitted(groups.size(), base);
  const double share = (1 - preparationShare - errorsShare) / double(groups.size());
  parallelForBlocks(groups.size(), 1, [&](std::size_t g, std::size_t) {
    if (!isBlack(polish.cells, groups[g]))
      fitted[g] = fitGroup(model, search, polish, base, groups[g], stop, progress, share);
  });
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t i = 0; i < parameters.values.size(); ++i)
      for (const int channel : groups[g]) parameters.values[i][channel] = fitted[g].values[i][channel];
  return parameters;
}

}  // namespace

FitResult fit(const TabulatedBrdf& table, const models::Model& model, const FitOptions& options,
              const TaskControl& control) {
  const auto start = std::chrono::steady_clock::now();
  ProgressMeter progress(control);
  const CellCensus census = takeCensus(table, options.maxPolarAngle);
  FitResult result;
  result.model = &model;
  result.usedCells = census.used;
  result.invalidCells = census.invalid;
  result.grazingCells = census.grazing;
  result.parameters = fitParameters(table, model, options, census, control.stop, progress);
  result.cancelled = control.stop.stop_requested();
  result.errors =
      metrics::brdfErrors(table, *model.instantiate(result.parameters), options.maxPolarAngle, options.gamma);
  progress.add(1);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace gonio::fitting
