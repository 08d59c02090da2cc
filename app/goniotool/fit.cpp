// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cstdio>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "app/goniotool/usage.h"
#include "core/editing/edit.h"
#include "core/study/accuracy_study.h"
#include "core/study/picture_search.h"

namespace gonio::tool {

namespace {

constexpr const char* bySnr = "snr";
constexpr const char* chooseGamma = "auto";

struct FitArguments {
  std::string material, model, metric = "log", gamma, sort, out;
  double maxAngle = degrees(metrics::defaultMaxPolarAngle);
  bool all = false;
  int samples = study::RankingOptions{}.picture.samples;

  fitting::FitOptions fitOptions() const {
    return {.metric = metrics::metricByName(metric),
            .gamma = finiteNumber(gamma).value_or(metrics::defaultGamma),
            .maxPolarAngle = radians(maxAngle)};
  }
};

std::string warningsText(const fitting::FitResult& result) {
  std::string text;
  for (const std::string& warning : result.warnings) text += "  note: " + warning + "\n";
  return text;
}

std::string text(const fitting::FitResult& result) {
  const models::ModelSpec& spec = result.model->spec();
  return std::string(spec.name) + ", " + number(result.seconds) + " s\n" + parametersText(spec, result.parameters) +
         errorsText(result.errors) + warningsText(result);
}

/// One fit, or the one of the gamma whose picture is best, with what was tried in `json`.
fitting::FitResult fitModel(const FitArguments& options, const fitting::FitBase& base, const models::Model& model,
                            const Tool& tool, Json& trials) {
  const TaskControl control = tool.control("fitting " + options.model);
  if (options.gamma != chooseGamma) return fitting::fit(base, model, options.fitOptions(), control);
  const std::vector<study::GammaTrial> tried = study::selectGamma(
      base, model, options.fitOptions(), {.width = 128, .height = 128, .samples = 32, .density = {}}, control);
  for (const study::GammaTrial& trial : tried)
    trials.push_back({{"gamma", trial.gamma}, {"renderedSnr", decibelsJson(trial.renderedSnr)}});
  tool.throwIfStopped();  // there may be no trial
  return tried.front().fit;
}

int fitOne(const FitArguments& options, const materials::Material& material, const Tool& tool) {
  const auto table = material.tabulated(tool.control("tabulating"));
  const models::Model& model = models::findModel(options.model);
  Json trials = Json::array();
  const fitting::FitResult result = fitModel(options, fitting::fitBase(material.brdf, table), model, tool, trials);
  tool.throwIfStopped();
  const std::shared_ptr<const Brdf> fitted = model.instantiate(result.parameters);
  WrittenMaterial written;
  if (!options.out.empty()) written = writeMaterial(material.name, fitted, options.out, tool, table->grid());
  Json json = fitJson(result);
  const study::MaterialQuality quality =
      qualityOf(material, *fitted, nullptr, rendering::smallComparisonPicture().samples, tool);
  json["renderedSnr"] = decibelsJson(quality.renderedSnr);
  json["brdfSnr"] = decibelsJson(quality.brdfSnr);
  addCost(json, quality.cost);
  json["averagedAzimuths"] = options.out.empty() ? 0 : averagedAzimuths(*fitted, options.out);
  if (written.bytes > 0) json["written"] = written.json();
  json["metric"] = options.metric;
  std::string heading;
  if (!trials.empty()) {
    json["gamma"] = trials[0]["gamma"];
    json["trials"] = trials;
    heading = "gamma " + number(trials[0]["gamma"].get<double>()) +
              " gives the highest rendered SNR in the comparison scene\n";
  } else if (options.metric == metricId(metrics::BrdfMetric::gamma)) {
    json["gamma"] = options.fitOptions().gamma;
  }
  print(tool, json,
        heading + text(result) + "rendered SNR " + number(quality.renderedSnr) + " dB, BRDF SNR " +
            number(quality.brdfSnr) + " dB, " + costText(quality.cost) + "\n" + written.text);
  return 0;
}

std::string rankingText(const std::vector<study::RankedFit>& ranking, metrics::BrdfMetric metric) {
  char line[160];
  std::snprintf(line, sizeof line, "%4s  %-34s %14s %17s %11s %9s\n", "", "model",
                std::string(metrics::metricId(metric)).c_str(), "rendered SNR [dB]", "parameters", "time [s]");
  std::string text = line;
  for (std::size_t i = 0; i < ranking.size(); ++i) {
    const study::RankedFit& row = ranking[i];
    std::snprintf(line, sizeof line, "%4zu  %-34s %14.6g %17.2f %11zu %9.2f\n", i + 1,
                  std::string(row.fit.model->spec().id).c_str(), row.fit.errors[static_cast<std::size_t>(metric)],
                  row.renderedSnr, row.parameterCount, row.fit.seconds);
    text += line;
  }
  return text + (ranking.empty() ? "" : warningsText(ranking.front().fit));
}

int fitAll(const FitArguments& options, const materials::Material& material, const Tool& tool) {
  const auto table = material.tabulated(tool.control("tabulating"));
  const metrics::BrdfMetric metric = metrics::metricByName(options.metric);
  study::RankingOptions rankingOptions;
  rankingOptions.fit = options.fitOptions();
  rankingOptions.picture.samples = options.samples;
  std::vector<study::RankedFit> ranking =
      study::rankFits({table, material.brdf}, rankingOptions, tool.control("fitting all models"));
  tool.throwIfStopped();
  const bool isBySnr = options.sort == bySnr;
  const metrics::BrdfMetric sortMetric = options.sort.empty() || isBySnr ? metric : metrics::metricByName(options.sort);
  sortRanking(ranking, isBySnr ? std::nullopt : std::optional(sortMetric));
  Json fits = Json::array();
  for (const study::RankedFit& row : ranking) fits.push_back(rankedFitJson(row));
  const Json json{{"fits", fits}, {"metric", options.metric}, {"scene", rendering::comparisonSceneName}};
  print(tool, json, rankingText(ranking, sortMetric));
  return 0;
}

void checkGamma(const FitArguments& options) {
  if (options.gamma.empty()) return;
  if (options.metric != metricId(metrics::BrdfMetric::gamma)) throw UsageError("fit: --gamma needs --metric gamma");
  if (options.gamma == chooseGamma && options.all)
    throw UsageError("fit: --gamma auto works for one model only; give --model");
}

void checkGammaText(const std::string& text) {
  const auto value = finiteNumber(text);
  const bool inRange = value && *value >= metrics::minGamma && *value <= metrics::maxGamma;
  if (text != chooseGamma && !inRange) throw UsageError("found '" + text + "', expected a number from 1 to 3, or auto");
}

int fit(const FitArguments& options, const Tool& tool) {
  if (options.model.empty() == !options.all) throw UsageError("fit: give one model with --model, or all with --all");
  if (options.all && !options.out.empty())
    throw UsageError("fit: --out writes one fitted model and cannot be used with --all; give --model");
  if (!options.all && !options.sort.empty()) throw UsageError("fit: --sort needs --all");
  checkGamma(options);
  if (!options.out.empty()) materials::checkWritableSuffix(options.out);
  const materials::Material material = documents::openMaterial(options.material, tool.control("reading"));
  return options.all ? fitAll(options, material, tool) : fitOne(options, material, tool);
}

}  // namespace

void addFit(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<FitArguments>();
  CLI::App* command = app.add_subcommand("fit", "Fits a model, or ranks all models by their fits");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--model", options->model, "Model to fit")->check(CLI::IsMember(modelIds()));
  command->add_flag("--all", options->all, "Fit and rank all models");
  std::vector<std::string> metricNames, orders;
  for (const metrics::BrdfMetric metric : metrics::minimisableMetrics()) metricNames.emplace_back(metricId(metric));
  for (const metrics::BrdfMetric metric : metrics::allBrdfMetrics()) orders.emplace_back(metricId(metric));
  orders.emplace_back(bySnr);
  command->add_option("--metric", options->metric, "Metric to minimise, see Metrics in docs/command-line.md (log)")
      ->check(CLI::IsMember(metricNames));
  command
      ->add_option(
          "--gamma", options->gamma,
          "Gamma of the metric gamma (values are raised to 1/gamma): 1 to 3, or auto for the highest rendered SNR (2)")
      ->type_name("NUMBER|auto")
      ->check(parsedBy(checkGammaText));
  command
      ->add_option("--sort", options->sort,
                   "Order of the ranking: a metric, or snr for the rendered SNR (the minimised metric)")
      ->check(CLI::IsMember(orders));
  command
      ->add_option("--samples", options->samples,
                   "Samples per pixel of the images of --all (" + std::to_string(options->samples) + ")")
      ->check(CLI::Range(1, 1 << 20))
      ->needs(command->get_option("--all"));
  command->add_option("--max-angle", options->maxAngle, "Max. polar angle of the cells that are fitted, degrees (85)")
      ->check(CLI::Range(1.0, 90.0));
  command->add_option("--out", options->out, outputHelp("File to write: the fitted model"))->group(outputGroup);
  command->callback([options, &tool] { tool.run = [options, &tool] { return fit(*options, tool); }; });
}

}  // namespace gonio::tool
