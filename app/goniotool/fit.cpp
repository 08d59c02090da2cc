// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit.h"

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"

namespace gonio::tool {

namespace {

struct Options {
  std::string material, model, metric = "log", out;
  double maxAngle = degrees(metrics::defaultMaxPolarAngle);
  bool all = false;
};

std::string text(const fitting::FitResult& result) {
  const models::ModelSpec& spec = result.model->spec();
  return std::string(spec.name) + ", " + number(result.seconds) + " s\n" + parametersText(spec, result.parameters) +
         errorsText(result.errors);
}

int fit(const Options& options, const Tool& tool) {
  if (options.model.empty() == !options.all) throw UsageError("fit: give one model by --model, or --all");
  if (options.all && !options.out.empty()) throw UsageError("fit: --out bakes one model; give --model");
  if (!options.out.empty()) checkOutput(options.out);
  const auto table = openMaterial(options.material, tool.control("reading")).tabulated(tool.control("tabulating"));
  const fitting::FitOptions fitOptions{.metric = metrics::metricByName(options.metric),
                                       .maxPolarAngle = radians(options.maxAngle)};
  Json fits = Json::array();
  std::string texts;
  for (const models::Model* model : models::allModels()) {
    const std::string id(model->spec().id);
    if (!options.all && id != options.model) continue;
    const fitting::FitResult result = fitting::fit(*table, *model, fitOptions, tool.control("fitting " + id));
    fits.push_back(fitJson(result));
    texts += text(result);
    if (!options.out.empty())
      writeMaterial(*bakeTable(*model->instantiate(result.parameters), table->grid(), tool.control("baking")),
                    options.out);
  }
  Json json = options.all ? Json{{"fits", fits}} : fits[0];
  json["metric"] = options.metric;
  print(tool, json, texts);
  return 0;
}

}  // namespace

void addFit(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("fit", "Fits a model: parameters, errors, time");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--model", options->model, "The model")->check(CLI::IsMember(modelIds()));
  command->add_flag("--all", options->all, "All models, one after the other");
  std::vector<std::string> metricNames;
  for (const metrics::BrdfMetric metric : metrics::minimisableMetrics()) metricNames.emplace_back(metricName(metric));
  command->add_option("--metric", options->metric, "What is made small (log)")->check(CLI::IsMember(metricNames));
  command->add_option("--max-angle", options->maxAngle, "Cells beyond this polar angle are left out, degrees (85)")
      ->check(CLI::Range(1.0, 90.0));
  command->add_option("--out", options->out, "Bakes the fitted model to this file");
  command->callback([options, &tool] { tool.run = [options, &tool] { return fit(*options, tool); }; });
}

}  // namespace gonio::tool
