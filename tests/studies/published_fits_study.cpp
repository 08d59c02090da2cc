// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies published_fits [--max-angle DEGREES] [--factors] TABLES MERL_FOLDER [SET ...]: the loss of published
// fits against that of our own, by the metric that the authors minimised, over the materials of a folder of MERL
// .binary files (../shared/tools/make-merl). For each set also the factors by which the published colours would fit
// best at the published shape: medians far from 1 mean that a convention is not the authors'. --factors prints these
// alone, without fits.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

#include "core/fitting/fit_data.h"
#include "core/fitting/fit_parameters.h"
#include "core/materials/material.h"
#include "core/models/registry.h"
#include "core/study/study_record.h"
#include "tests/studies/study_program.h"
#include "tests/support/published_fits.h"

namespace gonio::study::published_fits_study {
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

void compare(const fitting::FitData& data, const test::PublishedSet& set, const test::PublishedFit& published,
             Summary& summary) {
  const auto error = [&](const models::ParameterValues& parameters) {
    return data.errors(*set.model->instantiate(parameters))[std::size_t(set.metric)];
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
}

void print(const test::PublishedSet& set, const Summary& summary) {
  std::printf("%-28s %3zu pairs, not worse %3zu (%5.1f %%), median ratio of the losses %.3f, %.2f s a fit\n",
              set.name.c_str(), summary.pairs, summary.notWorse,
              100.0 * double(summary.notWorse) / double(std::max<std::size_t>(1, summary.pairs)),
              quantile(summary.ratios, 0.5), summary.seconds / double(std::max<std::size_t>(1, summary.pairs)));
  for (const auto& [key, values] : summary.factors)
    std::printf("    best %s over published, channel %d: quartiles %.3f %.3f %.3f\n", key.first.c_str(), key.second,
                quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75));
  for (const Worse& worse : summary.worse) std::printf("    worse: %-28s %.4f\n", worse.material.c_str(), worse.ratio);
}

struct Options {
  double maxAngle = 80;  ///< of Ngan et al.
  bool onlyFactors = false;
  std::vector<std::string> arguments;

  Options(int count, char** values) {
    for (int i = 1; i < count; ++i) {
      const std::string value = values[i];
      if (value == "--factors")
        onlyFactors = true;
      else if (value == "--max-angle" && i + 1 < count)
        maxAngle = std::strtod(values[++i], nullptr);
      else
        arguments.push_back(value);
    }
  }
};

void addMaterial(const std::filesystem::path& file, const std::vector<test::PublishedSet>& sets, const Options& options,
                 std::vector<Summary>& summaries) {
  const auto table = materials::readMaterial(file).tabulated();
  std::map<metrics::BrdfMetric, fitting::FitData> data;
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (const test::PublishedFit& published : sets[s].fits) {
      if (published.material != file.stem()) continue;
      const fitting::FitOptions fitOptions{.metric = sets[s].metric, .maxPolarAngle = radians(options.maxAngle)};
      const fitting::FitData& at = data.try_emplace(sets[s].metric, *table, fitOptions).first->second;
      addFactors(at, *sets[s].model, published.parameters, summaries[s]);
      if (!options.onlyFactors) compare(at, sets[s], published, summaries[s]);
    }
  std::fprintf(stderr, "%s\n", file.stem().c_str());
}

int run(const Options& options) {
  if (options.arguments.size() < 2) {
    std::fprintf(
        stderr, "usage: gonio_studies published_fits [--max-angle DEGREES] [--factors] TABLES MERL_FOLDER [SET ...]\n");
    return 2;
  }
  const std::set<std::string> wanted(options.arguments.begin() + 2, options.arguments.end());
  std::vector<test::PublishedSet> sets = test::readPublishedSets(options.arguments[0]);
  std::erase_if(sets, [&](const auto& set) { return !wanted.empty() && !wanted.contains(set.name); });
  std::vector<Summary> summaries(sets.size());
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(options.arguments[1]))
    if (entry.path().extension() == ".binary") files.insert(entry.path());
  for (const std::filesystem::path& file : files) addMaterial(file, sets, options, summaries);
  for (std::size_t s = 0; s < sets.size(); ++s) print(sets[s], summaries[s]);
  return 0;
}

int study(int count, char** arguments) { return run(Options(count, arguments)); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::published_fits_study
