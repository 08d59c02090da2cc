// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/fit_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fitting/fit_data.h"
#include "core/fitting/fit_parameters.h"
#include "core/models/registry.h"
#include "core/rendering/rendered_comparison.h"

namespace gonio::study {

namespace {

/// Share of the progress that the reference's picture takes; the models divide the rest evenly.
constexpr double referenceShare = 0.02;
/// Share of a model's progress that its fit takes; the rest is its picture.
constexpr double fitShare = 0.85;

RankedFit rankOne(const fitting::FitData& data, const models::Model& model, const RenderedComparison& comparison,
                  const TaskControl& control, double begin, double end) {
  const double fitEnd = begin + fitShare * (end - begin);
  RankedFit row;
  row.fit = fitting::fit(data, model, control.between(begin, fitEnd));
  control.throwIfStopped();
  ComparisonPicture picture = comparison.render(*model.instantiate(row.fit.parameters), control.between(fitEnd, end));
  row.renderedSnr = comparison.signalToNoiseRatio(picture);
  row.picture = std::move(picture.image);
  row.parameterCount = fitting::fittedParameterCount(model.spec());
  return row;
}

}  // namespace

std::vector<RankedFit> rankFits(const TabulatedBrdf& table, const Brdf& reference, const RankingOptions& options,
                                const TaskControl& control) {
  std::vector<const models::Model*> models = options.models;
  if (models.empty()) models.assign(models::allModels().begin(), models::allModels().end());
  std::vector<RankedFit> ranking;
  try {
    const RenderedComparison comparison(reference, options.picture, control.between(0, referenceShare));
    const fitting::FitData data(table, options.fit);
    const double share = (1 - referenceShare) / double(models.size());
    for (std::size_t m = 0; m < models.size(); ++m) {
      control.throwIfStopped();
      const double begin = referenceShare + double(m) * share;
      ranking.push_back(rankOne(data, *models[m], comparison, control, begin, begin + share));
      if (options.modelDone) options.modelDone(ranking.back());
    }
    control.report(1);
  } catch (const Cancelled&) {
  }
  return ranking;
}

void sortRanking(std::vector<RankedFit>& ranking, std::optional<metrics::BrdfMetric> metric) {
  const auto key = [&](const RankedFit& row) {
    const double value = metric ? row.fit.errors[static_cast<std::size_t>(*metric)] : -row.renderedSnr;
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  std::ranges::stable_sort(ranking, {}, key);
}

}  // namespace gonio::study
