// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/fit_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fitting/fit_parameters.h"

namespace gonio::study {

std::vector<RankedFit> rankFits(const StudySubject& subject, const RankingOptions& options,
                                const TaskControl& control) {
  std::vector<RankedFit> ranking;
  const auto symmetry =
      subject.reference->isIsotropic() ? fitting::DataSymmetry::isotropic : fitting::DataSymmetry::anisotropic;
  const auto add = [&](const MeasuredRepresentation& studied) {
    ranking.push_back({*studied.fit, studied.record.renderedSnr, studied.picture,
                       fitting::fittedParameterCount(studied.fit->model->spec(), symmetry)});
    if (options.modelDone) options.modelDone(ranking.back());
  };
  const StudyOptions study{
      .build = {.fit = options.fit, .dictionary = {}}, .picture = options.picture, .timed = false, .measured = add};
  runStudy(subject, representationsOf({.families = {RepresentationFamily::fit}, .models = options.models}), study,
           control);
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
