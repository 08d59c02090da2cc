// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/goniotool/tool.h"
#include "core/math/types.h"
#include "core/study/fit_ranking.h"

/// What subcommands print. JSON keys keep the order in which they are documented (docs/command-line.md).
namespace gonio::tool {

using Json = nlohmann::ordered_json;

/// One result: as JSON where that was asked for, else as text for people.
/// @throws Error when standard output does not take it.
void print(const Tool& tool, const Json& json, const std::string& text);

/// An error text of several lines (the refusals of all readers) as one.
std::string oneLine(const std::string& message);

/// Six significant digits.
std::string number(double value);
/// "0.1 0.2 0.3".
std::string rgbText(const Rgb& value);
Json rgbJson(const Rgb& value);

/// {"log": 0.01, ...} of values in the order of metrics::allBrdfMetrics().
Json errorsJson(const std::vector<double>& errors);
/// A line for each metric: id, error, unit, and what it is.
std::string errorsText(const std::vector<double>& errors);

/// {"mse": 0.01, ...} of values in the order of metrics::imageMetricRecords(), and a line for each.
Json imageErrorsJson(const std::vector<double>& errors);
std::string imageErrorsText(const std::vector<double>& errors);

/// {name: value or [r, g, b]}; a choice by its index. The text has a line for each, a choice by its name.
Json parametersJson(const models::ModelSpec& spec, const models::ParameterValues& values);
std::string parametersText(const models::ModelSpec& spec, const models::ParameterValues& values);

/// Keys of the design: model, parameters, errors, seconds; and the cells that were used and left out.
Json fitJson(const fitting::FitResult& result);
/// The same of a row of a ranking, with renderedSnr and parameterCount.
Json rankedFitJson(const study::RankedFit& row);

/// Decibels as JSON: null where they are not a finite number (equal materials, a black reference).
Json decibelsJson(double value);

/// The ids of all models, for --model.
std::vector<std::string> modelIds();

}  // namespace gonio::tool
