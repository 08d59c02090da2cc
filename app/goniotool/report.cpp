// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string_view>

#include "core/io/json_text.h"
#include "core/metrics/brdf_metrics.h"
#include "core/metrics/image_errors.h"
#include "core/models/parameters_json.h"
#include "core/rendering/render_picture.h"
#include "core/study/study_plot.h"
#include "core/study/study_record.h"
#include "core/support/text.h"

namespace gonio::tool {

BrdfQuality brdfQuality(const Brdf& measurement, const Brdf& test) {
  return {metrics::brdfErrors(measurement, test), metrics::brdfSignalToNoiseRatio(measurement, test)};
}

std::string addTableQuality(Json& json, const Brdf& measurement, const TabulatedBrdf& table) {
  if (formOf<TabulatedBrdf>(measurement) == &table) return {};
  const BrdfQuality quality = brdfQuality(measurement, table);
  json["table"] = {{"errors", errorsJson(quality.errors)}, {"brdfSnr", decibelsJson(quality.brdfSnr)}};
  return "the table that the method works on: BRDF SNR " + number(quality.brdfSnr) + " dB against the material\n";
}

study::MaterialQuality qualityOf(const materials::Material& material, const Brdf& used, const TabulatedBrdf* decoded,
                                 int samples, const Tool& tool) {
  rendering::RenderOptions picture = rendering::smallComparisonPicture();
  picture.samples = samples;
  return study::measureQuality(*material.brdf, used, decoded, picture, tool.control("measuring"));
}

void addQuality(Json& json, const study::MaterialQuality& quality) {
  json["errors"] = errorsJson(quality.errors);
  json["brdfSnr"] = decibelsJson(quality.brdfSnr);
  json["renderedSnr"] = decibelsJson(quality.renderedSnr);
  addCost(json, quality.cost);
}

std::string qualityText(const study::MaterialQuality& quality, double seconds) {
  return "BRDF SNR " + number(quality.brdfSnr) + " dB, rendered SNR " + number(quality.renderedSnr) + " dB, " +
         number(seconds) + " s, " + costText(quality.cost) + "\n" + errorsText(quality.errors);
}

void addCost(Json& json, const study::UseCost& cost) {
  json["evaluationNs"] = cost.evaluation.median;
  json["frameMs"] = cost.frameMilliseconds;
}

std::string costText(const study::UseCost& cost) {
  return study::shortQuantity(1e-9 * cost.evaluation.median, "s") + " per evaluation, " +
         study::shortQuantity(1e-3 * cost.frameMilliseconds, "s") + " per frame";
}

Json planJson(const rendering::EffectPlan& plan, const rendering::EffectCosts* costs) {
  Json list = Json::array();
  for (std::size_t i = 0; i < rendering::effectCount; ++i) {
    const rendering::EffectDecision& decision = plan.decisions[i];
    Json one{{"effect", rendering::effectId(rendering::Effect(i))},
             {"simulated", decision.simulated},
             {"calledFor", decision.calledFor},
             {"reason", decision.reason}};
    if (costs) {
      const rendering::EffectCost& cost = costs->effects[i];
      one["seconds"] = cost.seconds;
      one["secondsNoise"] = cost.secondsNoise;
      one["difference"] = cost.difference;
      one["noise"] = cost.noise;
    }
    list.push_back(std::move(one));
  }
  return list;
}

std::string timeText(const rendering::EffectCost& cost) {
  const std::string time = number(cost.seconds) + " +- " + number(cost.secondsNoise) + " s";
  return cost.isWithinNoise() ? time + " (within noise)" : time;
}

std::string planText(const rendering::EffectPlan& plan, const rendering::EffectCosts* costs) {
  std::string text;
  for (std::size_t i = 0; i < rendering::effectCount; ++i) {
    const rendering::EffectDecision& decision = plan.decisions[i];
    text += std::string("  ") + rendering::effectId(rendering::Effect(i)) + ": " + (decision.simulated ? "yes" : "no");
    if (decision.simulated != decision.calledFor) text += " (forced)";
    text += ", " + decision.reason;
    if (costs)
      text += "; " + timeText(costs->effects[i]) + ", changes the image by " +
              number(100 * costs->effects[i].difference) + " % (noise " + number(100 * costs->effects[i].noise) + " %)";
    text += "\n";
  }
  return text;
}

namespace {

std::string metricLine(std::string_view id, const std::string& value, std::string_view name) {
  char line[160];
  std::snprintf(line, sizeof line, "  %-27s %-24s %s\n", std::string(id).c_str(), value.c_str(),
                std::string(name).c_str());
  return line;
}

}  // namespace

void print(const Tool& tool, const Json& json, const std::string& text) {
  if (tool.json)
    std::cout << io::jsonText(json, 2) << '\n';
  else
    std::cout << text;
  if (!std::cout.flush()) throw Error("standard output cannot be written");
}

std::string oneLine(const std::string& message) {
  std::string line;
  for (std::string_view rest = message; !rest.empty();) {
    const Utf8Character character = firstCharacter(rest);
    if (character.code == '\n')
      line += line.ends_with(':') ? " " : "; ";
    else if (!character.isPlain())
      line += '?';
    else if (character.code != ' ' || !line.ends_with(' '))  // the lines of a list are indented
      line += rest.substr(0, character.bytes);
    rest.remove_prefix(character.bytes);
  }
  return line;
}

std::string number(double value) {
  if (std::isnan(value)) return "undefined";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

std::string rgbText(const Rgb& value) { return number(value.x) + " " + number(value.y) + " " + number(value.z); }
Json rgbJson(const Rgb& value) { return {value.x, value.y, value.z}; }

Json errorsJson(const std::vector<double>& errors) {
  Json json = Json::object();
  const auto metrics = metrics::allBrdfMetrics();
  for (std::size_t i = 0; i < errors.size(); ++i) json[std::string(metrics::metricId(metrics[i]))] = errors[i];
  return json;
}

std::string errorsText(const std::vector<double>& errors) {
  std::string text;
  const auto records = metrics::metricRecords();
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const std::string value = number(errors[i]) + (records[i].unit.empty() ? "" : " ") + std::string(records[i].unit);
    text += metricLine(records[i].id, value, records[i].name);
  }
  return text;
}

Json imageErrorsJson(const std::vector<double>& errors) {
  Json json = Json::object();
  const auto records = metrics::imageMetricRecords();
  for (std::size_t i = 0; i < errors.size(); ++i) json[std::string(records[i].id)] = errors[i];
  return json;
}

std::string imageErrorsText(const std::vector<double>& errors) {
  std::string text;
  const auto records = metrics::imageMetricRecords();
  for (std::size_t i = 0; i < errors.size(); ++i)
    text += metricLine(records[i].id, number(errors[i]), std::string(records[i].name) + " of the images");
  return text;
}

Json parametersJson(const models::ModelSpec& spec, const models::ParameterValues& values) {
  return models::parametersToJson(spec, values);
}

std::string parametersText(const models::ModelSpec& spec, const models::ParameterValues& values) {
  std::string text;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const models::ParameterSpec& parameter = spec.parameters[i];
    const Rgb& value = values.values[i];
    text += "  " + std::string(parameter.id) + " ";
    if (!parameter.choices.empty())
      text += parameter.choices[std::min(std::size_t(value.x + 0.5), parameter.choices.size() - 1)];
    else
      text += parameter.perChannel ? rgbText(value) : number(value.x);
    text += parameter.unit.empty() ? "\n" : " " + std::string(parameter.unit) + "\n";
  }
  return text;
}

Json fitJson(const fitting::FitResult& result) {
  const models::ModelSpec& spec = result.model->spec();
  return {{"model", spec.id},
          {"parameters", parametersJson(spec, result.parameters)},
          {"errors", errorsJson(result.errors)},
          {"seconds", result.seconds},
          {"usedCells", result.usedCells},
          {"invalidCells", result.invalidCells},
          {"grazingCells", result.grazingCells},
          {"warnings", result.warnings}};
}

Json rankedFitJson(const study::RankedFit& row) {
  Json json = fitJson(row.fit);
  json["renderedSnr"] = decibelsJson(row.renderedSnr);
  json["parameterCount"] = row.parameterCount;
  return json;
}

Json decibelsJson(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::vector<std::string> modelIds() {
  std::vector<std::string> ids;
  for (const models::Model* model : models::allModels()) ids.emplace_back(model->spec().id);
  return ids;
}

}  // namespace gonio::tool
