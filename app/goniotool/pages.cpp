// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/pages.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <vector>

#include "app/goniotool/usage.h"
#include "core/baselines/baselines.h"
#include "core/export/export_target.h"
#include "core/metrics/brdf_metric.h"
#include "core/metrics/image_errors.h"
#include "core/models/model.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

using Cells = std::vector<std::string>;

/// A row of a table: on one line, without bars inside the cells.
std::string rowOf(const Cells& cells) {
  std::string row = "|";
  for (const std::string& text : cells) {
    row += ' ';
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      for (const char c : word) row += c == '|' ? std::string("\\|") : std::string(1, c);
      row += ' ';
    }
    row += '|';
  }
  return row + '\n';
}

std::string tableOf(const Cells& titles, const std::vector<Cells>& rows) {
  std::string table = rowOf(titles) + "|";
  for (std::size_t i = 0; i < titles.size(); ++i) table += "---|";
  table += '\n';
  for (const Cells& row : rows) table += rowOf(row);
  return table;
}

std::string codeSpan(std::string_view text) { return "`" + std::string(text) + "`"; }

void append(std::string& list, std::string_view separator, std::string_view text) {
  if (!list.empty()) list += separator;
  list += text;
}

/// @param name of a subcommand, or "dictionary train"; "goniotool": the options of all.
std::string optionTable(const CLI::App& app, const std::string& name) {
  const CLI::App* command = &app;
  std::istringstream words(name == app.get_name() ? "" : name);
  for (std::string word; words >> word;) {
    const auto found = command->get_subcommands([&](const CLI::App* one) { return one->get_name() == word; });
    if (found.empty()) throw Error("no subcommand " + name);
    command = found.front();
  }
  const HelpFormatter help;
  std::vector<Cells> rows;
  for (const CLI::Option* option : command->get_options())
    if (!option->get_group().empty() && !option->check_lname("help"))
      rows.push_back({codeSpan(option->get_name(option->get_positional())) + help.make_option_opts(option),
                      help.make_option_desc(option)});
  return rows.empty() ? std::string() : tableOf({"option", "effect"}, rows);
}

/// "`diffuse` k_d, `roughness` alpha"; of coefficients the first and the last.
std::string parameterList(const models::ModelSpec& spec) {
  using enum models::ParameterGroup;
  const auto isCoefficient = [&](std::size_t i) {
    return i < spec.parameters.size() && spec.parameters[i].group == coefficients;
  };
  std::string list;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const models::ParameterSpec& parameter = spec.parameters[i];
    if (i > 0 && isCoefficient(i - 1) && isCoefficient(i) && isCoefficient(i + 1)) {
      if (!list.ends_with("...")) append(list, ", ", "...");
      continue;
    }
    append(list, ", ", codeSpan(parameter.id));
    if (!parameter.symbol.empty()) list += " " + std::string(parameter.symbol);
  }
  return list;
}

/// The formulas of parameters that the formula of the model does not contain. Those of Fresnel terms are the same for
/// all models.
std::string partsOf(const models::ModelSpec& spec) {
  std::string parts;
  for (const models::ParameterSpec& parameter : spec.parameters)
    if (parameter.group != models::ParameterGroup::fresnel &&
        spec.formula.find(parameter.formula) == std::string_view::npos &&
        parts.find(parameter.formula) == std::string::npos && parameter.id != "fresnel")
      append(parts, "; ", parameter.formula);
  return parts;
}

std::string modelTable() {
  std::vector<Cells> rows;
  for (const models::Model* model : models::allModels()) {
    const models::ModelSpec& spec = model->spec();
    rows.push_back({codeSpan(spec.id) + (spec.reciprocal ? "" : " *"), std::string(spec.formula), partsOf(spec),
                    parameterList(spec), std::string(spec.reference)});
  }
  return tableOf({"id", "formula", "where", "parameters", "source"}, rows);
}

std::string metricTable() {
  std::vector<Cells> rows;
  for (const metrics::MetricRecord& record : metrics::metricRecords())
    rows.push_back(
        {codeSpan(record.id), std::string(record.formula), std::string(record.unit), std::string(record.reference)});
  return tableOf({"id", "definition", "unit", "source"}, rows);
}

std::string imageMetricTable() {
  std::vector<Cells> rows;
  for (const metrics::ImageMetricRecord& record : metrics::imageMetricRecords())
    rows.push_back(
        {codeSpan(record.id), std::string(record.formula), std::string(record.domain), std::string(record.reference)});
  return tableOf({"id", "definition", "domain", "source"}, rows);
}

std::string baselineTable() {
  std::vector<Cells> rows;
  for (const baselines::Baseline& baseline : baselines::allBaselines())
    rows.push_back({codeSpan(baseline.id), std::string(baseline.name), std::string(baseline.reference)});
  return tableOf({"id", "method", "source"}, rows);
}

std::string targetTable() {
  std::vector<Cells> rows;
  for (const exports::ExportTarget& target : exports::exportTargets()) {
    std::string files;
    for (const std::string_view suffix : target.suffixes) append(files, ", ", "NAME" + std::string(suffix));
    rows.push_back({codeSpan(target.id), std::string(target.label), std::string(target.purpose), files,
                    std::string(target.limitations)});
  }
  return tableOf({codeSpan("--for"), "target", "purpose", "files", "represents"}, rows);
}

std::string recordTable(const std::string& name) {
  if (name == "models") return modelTable();
  if (name == "metrics") return metricTable();
  if (name == "image-metrics") return imageMetricTable();
  if (name == "baselines") return baselineTable();
  if (name == "targets") return targetTable();
  if (name == "scenes") return sceneTable();
  if (name == "figures") return figureTable();
  throw Error("no table " + name);
}

}  // namespace

std::string completePage(const CLI::App& app, const std::string& text) {
  static const std::regex comment("<!-- (options|table): ([a-z -]+) -->");
  std::string page;
  std::istringstream lines(text);
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, comment))
      page += found[1] == "options" ? optionTable(app, found[2]) : recordTable(found[2]);
    else
      page += line + '\n';
  return page;
}

}  // namespace gonio::tool
