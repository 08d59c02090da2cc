// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/goniotool/pages.h"
#include "app/goniotool/report.h"
#include "app/goniotool/usage.h"
#include "core/io/atomic_file.h"
#include "core/reproduction/report.h"

namespace gonio::tool {

namespace {

using namespace reproduction;

struct ReproduceArguments {
  InputOptions inputs;
  std::vector<std::string> only;
  std::string out;
  bool again = false, list = false;
};

double expectedMinutes(const FigureRecord& record, bool quick) {
  return quick ? record.quickMinutes : record.fullMinutes;
}

/// The time left, from the minutes of the records and the speed of this machine so far.
class Estimate {
 public:
  Estimate(std::span<const FigureRecord* const> figures, bool quick) : quick_(quick) {
    for (const FigureRecord* figure : figures) left_ += expectedMinutes(*figure, quick);
  }
  void finished(const FigureRecord& figure, double minutes, bool isKept) {
    left_ -= expectedMinutes(figure, quick_);
    if (isKept) return;
    expected_ += expectedMinutes(figure, quick_);
    taken_ += minutes;
  }
  /// "about 12 min left".
  std::string text() const {
    const double minutes = left_ * (expected_ > 0 ? taken_ / expected_ : 1);
    if (minutes > 90) return "about " + std::to_string(std::lround(minutes / 60)) + " h left";
    return "about " + std::to_string(std::max(1L, std::lround(minutes))) + " min left";
  }

 private:
  bool quick_;
  double left_ = 0, expected_ = 0, taken_ = 0;
};

/// Makes a figure or finds it in the folder; an error is part of the result. @throws Cancelled.
FigureResult makeOrKeep(const FigureRecord& record, Inputs& inputs, const ReproduceArguments& options,
                        const TaskControl& control) {
  FigureResult result{.record = &record};
  try {
    result.materials = usedMaterials(materialsOf(record, inputs), inputs);
    const std::string key = figureKey(record, result.materials, inputs.quick());
    if (!options.again)
      if (auto kept = keptFigure(options.out, record, key)) return *std::move(kept);
    const auto start = std::chrono::steady_clock::now();
    const MadeFigure made = record.make(record, inputs, control);
    control.throwIfStopped();
    result.values = made.values;
    result.remarks = made.remarks;
    result.seconds = secondsSince(start);
    writeFigure(options.out, result, made, key);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    result.error = oneLine(error.what());
  }
  return result;
}

Json figureJson(const FigureResult& result) {
  Json values = Json::array();
  for (const ReproducedValue& value : result.values) {
    const PrintedValue* printed = printedValue(*result.record, value.name);
    values.push_back({{"name", value.name},
                      {"unit", value.unit},
                      {"value", decibelsJson(value.value)},
                      {"printed", printed ? Json(printed->value) : Json(nullptr)}});
  }
  return {{"figure", result.record->id},
          {"title", result.record->title},
          {"values", values},
          {"seconds", result.seconds},
          {"kept", result.isKept},
          {"error", result.error.empty() ? Json(nullptr) : Json(result.error)}};
}

std::string figureText(const FigureResult& result) {
  std::string text = result.record->name() + ": " + std::string(result.record->title);
  if (!result.error.empty()) return text + "\n  not made: " + result.error + "\n";
  text += result.isKept ? ", kept\n" : ", " + number(result.seconds) + " s\n";
  for (const ReproducedValue& value : result.values) {
    const std::string unit = value.unit.empty() ? "" : " " + value.unit;
    text += "  " + value.name + ": " + number(value.value) + unit;
    if (const PrintedValue* printed = printedValue(*result.record, value.name))
      text += ", printed " + number(printed->value) + unit + ": " + comparisonText(*printed, value);
    text += "\n";
  }
  return text;
}

std::vector<const FigureRecord*> figuresOf(const ReproduceArguments& options) {
  try {
    return selectedFigures(options.only);
  } catch (const Error& error) {
    throw UsageError("reproduce: --only: " + std::string(error.what()));
  }
}

std::string minutesText(double minutes) {
  if (minutes >= 90) return std::to_string(std::lround(minutes / 60)) + " h";
  if (minutes >= 1) return std::to_string(std::lround(minutes)) + " min";
  return std::to_string(std::max(1L, std::lround(60 * minutes))) + " s";
}

std::string tableOfFigures(std::span<const FigureRecord* const> figures) {
  std::string text = "| | shows | printed values | quick | full |\n|---|---|---|---|---|\n";
  for (const FigureRecord* figure : figures)
    text += "| " + figure->name() + " | " + std::string(figure->title) + " | " +
            (figure->printed.empty() ? "none" : std::to_string(figure->printed.size())) + " | " +
            minutesText(figure->quickMinutes) + " | " + minutesText(figure->fullMinutes) + " |\n";
  return text;
}

int list(std::span<const FigureRecord* const> figures, const Tool& tool) {
  Json json = Json::array();
  for (const FigureRecord* figure : figures) {
    Json printed = Json::array();
    for (const PrintedValue& value : figure->printed) printed.push_back({{"name", value.name}, {"value", value.value}});
    json.push_back({{"figure", figure->id},
                    {"files", figure->stem()},
                    {"title", figure->title},
                    {"printed", printed},
                    {"source", figure->source},
                    {"differences", figure->differences},
                    {"quickMinutes", figure->quickMinutes},
                    {"fullMinutes", figure->fullMinutes}});
  }
  print(tool, {{"figures", json}}, tableOfFigures(figures));
  return 0;
}

int reproduce(const ReproduceArguments& options, const Tool& tool) {
  const auto figures = figuresOf(options);
  if (options.list) return list(figures, tool);
  if (options.out.empty()) throw UsageError("reproduce: --out is missing: name a folder, or use --list");
  Inputs inputs(options.inputs);
  std::error_code cause;
  std::filesystem::create_directories(options.out, cause);
  if (!std::filesystem::is_directory(options.out))
    throw Error(options.out + ": the folder cannot be created: " + cause.message());
  const std::filesystem::path report = std::filesystem::path(options.out) / "report.html";
  io::checkWritable(report);
  const bool usesCopies = inputs.folder(MaterialSet::merl).empty();
  if (usesCopies) std::fputs("note: no MERL files were given (--merl): near-measured copies stand for them\n", stderr);
  Estimate estimate(figures, inputs.quick());
  std::vector<FigureResult> results;
  for (const FigureRecord* figure : figures) {
    tool.throwIfStopped();
    const std::string number = std::to_string(results.size() + 1) + " of " + std::to_string(figures.size());
    const FigureResult result = makeOrKeep(*figure, inputs, options,
                                           tool.control(figure->name() + " (" + number + ", " + estimate.text() + ")"));
    estimate.finished(*figure, result.seconds / 60, result.isKept);
    results.push_back(result);
    // After each figure: an interrupted run leaves a report of what it made.
    io::writeFileAtomically(report, reportHtml(inputs, results));
  }
  Json json{{"copies", usesCopies}, {"quick", inputs.quick()}, {"figures", Json::array()}, {"report", report.string()}};
  std::string text;
  bool failed = false;
  for (const FigureResult& result : results) {
    json["figures"].push_back(figureJson(result));
    text += figureText(result);
    failed = failed || !result.error.empty();
  }
  print(tool, json, text + report.string() + ": the report\n");
  return failed ? 1 : 0;
}

/// "2.1, 2.6, ...", for the help.
std::string knownIds() {
  std::string ids;
  for (const FigureRecord& figure : allFigures()) ids += (ids.empty() ? "" : ", ") + std::string(figure.id);
  return ids;
}

double totalMinutes(bool quick) {
  double minutes = 0;
  for (const FigureRecord& figure : allFigures()) minutes += expectedMinutes(figure, quick);
  return minutes;
}

}  // namespace

std::string figureTable() { return tableOfFigures(selectedFigures({})); }

void addReproduce(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<ReproduceArguments>();
  CLI::App* command =
      app.add_subcommand("reproduce", "Makes the figures and tables of Tongbuasirilai 2023 from your materials");
  const std::array titles{"Folder of MERL files (.binary) (bundled near-measured copies)",
                          "Folder of RGL files (.bsdf) (bundled measured files and near-measured copies)",
                          "Folder of DTU files (.binary) (bundled near-measured copies)"};
  for (std::size_t set = 0; set < titles.size(); ++set)
    command->add_option("--" + std::string(materialSetNames[set]), options->inputs.folders[set], titles[set])
        ->type_name("FOLDER");
  command->add_option("--only", options->only, "Figures and tables to make: " + knownIds() + " (all)")
      ->type_name("ID")
      ->delimiter(',');
  command->add_flag("--quick", options->inputs.quick,
                    "Four materials where a figure uses whole sets, small pictures, few samples: about " +
                        minutesText(totalMinutes(true)) + " on two cores instead of " +
                        minutesText(totalMinutes(false)));
  command->add_flag(
      "--again", options->again,
      "Also make the figures that are in the folder and were made from the same materials by this version");
  command->add_flag("--list", options->list,
                    "List the figures with their printed values and times instead of making them");
  command
      ->add_option("--out", options->out,
                   "Folder for report.html and a PDF, SVG, CSV and JSON file of each figure, created if needed")
      ->group(outputGroup);
  command->callback([options, &tool] { tool.run = [options, &tool] { return reproduce(*options, tool); }; });
}

}  // namespace gonio::tool
