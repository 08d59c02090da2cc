// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// published_fits_study TABLES MERL_FOLDER [SET ...]: the loss of published fits against that of our own, by the metric
// that the authors minimised, over the materials of a folder of MERL .binary files (../shared/tools/make-merl). For
// each set also the factors by which the published colours would fit best at the published shape: medians far from 1
// mean that a convention is not the authors'.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

#include "core/fitting/fit_data.h"
#include "core/fitting/fit_parameters.h"
#include "core/io/material.h"
#include "core/models/registry.h"
#include "tests/support/published_fits.h"

using namespace gonio;

namespace {

/// The fit looks at some of the cells, and prefers parameters near the defaults: that much may be lost.
constexpr double tolerance = 1e-3;

struct Worse {
  std::string material;
  double ratio;
};
struct Summary {
  std::size_t pairs = 0, notWorse = 0;
  double seconds = 0;
  std::vector<double> ratios;
  std::vector<Worse> worse;
  std::map<std::pair<std::string, int>, std::vector<double>> factors;  ///< by linear parameter and channel
};

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
  return values[values.size() / 2];
}

/// Best linear parameters at the published non-linear ones, over the published.
void addFactors(const fitting::FitData& data, const models::Model& model, const models::ParameterValues& published,
                Summary& summary) {
  fitting::ProjectedProblem problem(model, data.polish(9), published, {}, {0, 1, 2});
  problem.cost({});
  const models::ParameterValues best = problem.bestParameters();
  for (const std::size_t i : parametersOf(model.spec(), published, fitting::FitRole::linear))
    for (int c = 0; c < 3; ++c)
      if (published.values[i][c] > 1e-3 && best.values[i][c] > 0)
        summary.factors[{std::string(model.spec().parameters[i].id), c}].push_back(best.values[i][c] /
                                                                                   published.values[i][c]);
}

void compare(const fitting::FitData& data, const testing::PublishedSet& set, const testing::PublishedFit& published,
             Summary& summary) {
  const auto error = [&](const models::ParameterValues& parameters) {
    return metrics::brdfError(set.metric, data.table(), *set.model->instantiate(parameters));
  };
  const fitting::FitResult ours = fit(data, *set.model, {}, published.parameters);
  const double ratio = ours.errors[std::size_t(set.metric)] / error(published.parameters);
  ++summary.pairs;
  summary.seconds += ours.seconds;
  summary.ratios.push_back(ratio);
  if (ratio <= 1 + tolerance)
    ++summary.notWorse;
  else
    summary.worse.push_back({published.material, ratio});
  addFactors(data, *set.model, published.parameters, summary);
}

void print(const testing::PublishedSet& set, const Summary& summary) {
  std::printf("%-28s %3zu pairs, not worse %3zu (%5.1f %%), median ratio of the losses %.3f, %.2f s a fit\n",
              set.name.c_str(), summary.pairs, summary.notWorse,
              100.0 * double(summary.notWorse) / double(std::max<std::size_t>(1, summary.pairs)),
              summary.ratios.empty() ? 0 : median(summary.ratios), summary.seconds / double(summary.pairs));
  for (const auto& [key, values] : summary.factors)
    std::printf("    best %s over published, channel %d: %.3f\n", key.first.c_str(), key.second, median(values));
  for (const Worse& worse : summary.worse) std::printf("    worse: %-28s %.4f\n", worse.material.c_str(), worse.ratio);
}

int run(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "usage: published_fits_study TABLES MERL_FOLDER [SET ...]\n");
    return 2;
  }
  const std::set<std::string> wanted(arguments + 3, arguments + count);
  std::vector<testing::PublishedSet> sets = testing::readPublishedSets(arguments[1]);
  std::erase_if(sets, [&](const auto& set) { return !wanted.empty() && !wanted.contains(set.name); });
  std::vector<Summary> summaries(sets.size());
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[2]))
    if (entry.path().extension() == ".binary") files.insert(entry.path());
  for (const std::filesystem::path& file : files) {
    const auto table = io::readMaterial(file).tabulated();
    std::map<metrics::BrdfMetric, fitting::FitData> data;
    for (std::size_t s = 0; s < sets.size(); ++s)
      for (const testing::PublishedFit& published : sets[s].fits) {
        if (published.material != file.stem()) continue;
        const auto [at, isNew] =
            data.try_emplace(sets[s].metric, *table, fitting::FitOptions{.metric = sets[s].metric});
        compare(at->second, sets[s], published, summaries[s]);
      }
    std::fprintf(stderr, "%s\n", file.stem().c_str());
  }
  for (std::size_t s = 0; s < sets.size(); ++s) print(sets[s], summaries[s]);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
