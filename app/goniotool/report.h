// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/goniotool/tool.h"
#include "core/materials/material.h"
#include "core/math/types.h"
#include "core/rendering/effect_costs.h"
#include "core/study/accuracy_study.h"

/// Output of the subcommands. JSON keys have the documented order (docs/command-line.md).
namespace gonio::tool {

using Json = nlohmann::ordered_json;

/// Prints a result as JSON if requested, else as text.
/// @throws Error if writing to standard output fails.
void print(const Tool& tool, const Json& json, const std::string& text);

/// Joins the lines of an error message (e.g. of several readers) to one line. Errors quote damaged
/// files, which must not control the terminal: control characters, and bytes that are not UTF-8, become question marks.
std::string oneLine(const std::string& message);

/// Six significant digits; "undefined" for NaN, such as the SNR of a black material.
std::string number(double value);
/// "0.1 0.2 0.3".
std::string rgbText(const Rgb& value);
Json rgbJson(const Rgb& value);

/// {"log": 0.01, ...} of values in the order of metrics::allBrdfMetrics().
Json errorsJson(const std::vector<double>& errors);
/// One line per metric: id, error, unit and description.
std::string errorsText(const std::vector<double>& errors);

/// {"mse": 0.01, ...} of values in the order of metrics::imageMetricRecords(), and a line for each.
Json imageErrorsJson(const std::vector<double>& errors);
std::string imageErrorsText(const std::vector<double>& errors);

/// {name: value or [r, g, b]}; a choice by its index. The text has a line for each, a choice by its name.
Json parametersJson(const models::ModelSpec& spec, const models::ParameterValues& values);
std::string parametersText(const models::ModelSpec& spec, const models::ParameterValues& values);

/// Keys: model, parameters, errors, seconds, the numbers of used and omitted cells, and warnings.
Json fitJson(const fitting::FitResult& result);
/// The same for a row of a ranking, with renderedSnr and parameterCount.
Json rankedFitJson(const study::RankedFit& row);

/// Decibels as JSON; null if not finite (equal materials, a black reference).
Json decibelsJson(double value);

/// The ids of all models, for --model.
std::vector<std::string> modelIds();

/// Errors against a measurement.
struct BrdfQuality {
  std::vector<double> errors;  ///< in the order of metrics::allBrdfMetrics()
  double brdfSnr = 0;          ///< dB
};
BrdfQuality brdfQuality(const Brdf& measurement, const Brdf& test);

/// The errors of the table that a method works on, under the key `table`, if the measurement is not this table itself.
/// @return a line of text, or "".
std::string addTableQuality(Json& json, const Brdf& measurement, const TabulatedBrdf& table);

/// study::measureQuality() against the material in its native form. @param used as there. @param samples per pixel of
/// the pictures. @throws Cancelled.
study::MaterialQuality qualityOf(const materials::Material& material, const Brdf& used, const TabulatedBrdf* decoded,
                                 int samples, const Tool& tool);

/// Adds errors, brdfSnr, renderedSnr, evaluationNs and frameMs.
void addQuality(Json& json, const study::MaterialQuality& quality);
/// "BRDF SNR 31 dB, rendered SNR 28 dB", the times, and a line per error.
std::string qualityText(const study::MaterialQuality& quality, double seconds);

/// Adds evaluationNs and frameMs.
void addCost(Json& json, const study::UseCost& cost);
/// "52 ns per evaluation, 14 ms per frame".
std::string costText(const study::UseCost& cost);

// Reports of effect plans.

/// [{effect, simulated, calledFor, reason}]; `calledFor` is whether the analysis requires the effect, without
/// overrides. With measured costs also seconds, secondsNoise, difference and noise.
Json planJson(const rendering::EffectPlan& plan, const rendering::EffectCosts* costs = nullptr);
/// One line per effect.
std::string planText(const rendering::EffectPlan& plan, const rendering::EffectCosts* costs = nullptr);

}  // namespace gonio::tool
