// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/reproduction/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/figures/figure_formats.h"
#include "core/io/atomic_file.h"
#include "core/io/json_text.h"
#include "core/io/sha256.h"
#include "core/reproduction/charts.h"
#include "core/study/study_record.h"
#include "core/support/text.h"

namespace gonio::reproduction {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* figureSuffixes[] = {".pdf", ".csv", ".svg", ".json"};

std::filesystem::path fileOfFigure(const std::filesystem::path& folder, const FigureRecord& record,
                                   const char* suffix) {
  return folder / (record.stem() + suffix);
}

OrderedJson resultJson(const FigureResult& result, const std::string& key) {
  OrderedJson values = OrderedJson::array(), materials = OrderedJson::array();
  for (const ReproducedValue& value : result.values)
    values.push_back({{"name", value.name},
                      {"unit", value.unit},
                      {"value", std::isfinite(value.value) ? OrderedJson(value.value) : OrderedJson(nullptr)}});
  for (const UsedMaterial& material : result.materials)
    materials.push_back({{"name", material.name}, {"file", material.file}, {"sha256", material.sha256}});
  return {{"figure", result.record->id},
          {"key", key},
          {"values", values},
          {"remarks", result.remarks},
          {"seconds", result.seconds},
          {"materials", materials}};
}

class Html {
 public:
  Html& element(const char* name, std::string_view text) {
    out_ += std::string("<") + name + ">" + xmlText(text) + "</" + name + ">\n";
    return *this;
  }
  Html& raw(const std::string& markup) {
    out_ += markup;
    return *this;
  }
  void row(std::initializer_list<std::string> cells, const char* cell = "td") {
    out_ += "<tr>";
    for (const std::string& text : cells) out_ += std::string("<") + cell + ">" + xmlText(text) + "</" + cell + ">";
    out_ += "</tr>\n";
  }
  const std::string& str() const { return out_; }

 private:
  std::string out_;
};

constexpr const char* pageHead =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Reproduction of Tongbuasirilai "
    "2023</title>\n"
    "<style>body{font:15px/1.45 sans-serif;max-width:68em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:1em 0}td,th{border:1px solid #bbb;padding:.25em .6em;text-align:left}"
    "th{background:#f0f0f0}img{width:100%;border:1px solid #ddd}.note{background:#fff4d6;padding:.6em 1em}"
    "code{font-size:85%}</style></head><body>\n";

std::string valueWithUnit(double value, const std::string& unit) {
  return shortText(value) + (unit.empty() ? "" : " " + unit);
}

/// Names of the substituted subjects in a sentence.
std::string substitutionText(const FigureRecord& record, const Inputs& inputs) {
  std::string text;
  for (const Subject& subject : record.subjects) {
    const InputMaterial material = inputs.find(subject);
    if (!material.replaced.empty())
      text += (text.empty() ? "" : ", ") + material.name + " for " + std::string(material.replaced);
  }
  return text.empty() ? "" : "Other materials than in the print, which are missing here: " + text + ".";
}

void addComparisons(Html& html, std::span<const FigureResult> results) {
  html.element("h2", "Printed and reproduced values").raw("<table>\n");
  html.row({"", "value", "here", "printed", "difference"}, "th");
  for (const FigureResult& result : results)
    for (const ReproducedValue& value : result.values)
      if (const PrintedValue* printed = printedValue(*result.record, value.name))
        html.row({result.record->name(), value.name, valueWithUnit(value.value, value.unit),
                  valueWithUnit(printed->value, value.unit), comparisonText(*printed, value)});
  html.raw("</table>\n");
}

void addFigure(Html& html, const FigureResult& result, const Inputs& inputs) {
  const FigureRecord& record = *result.record;
  html.raw("<h2 id=\"" + record.stem() + "\">" + xmlText(record.name() + ": " + std::string(record.title)) + "</h2>\n");
  html.element("p", record.shows);
  if (!result.error.empty()) {
    html.raw("<p class=\"note\">Not made: " + xmlText(result.error) + "</p>\n");
    return;
  }
  html.raw("<img src=\"" + record.stem() + ".svg\" alt=\"" + xmlText(record.title) + "\">\n<p>");
  for (const char* suffix : {".pdf", ".csv"})
    html.raw("<a href=\"" + record.stem() + suffix + "\">" + record.stem() + suffix + "</a> ");
  html.raw("</p>\n");
  if (!result.values.empty()) {
    html.raw("<table>\n");
    html.row({"value", "here", "printed", "difference"}, "th");
    for (const ReproducedValue& value : result.values) {
      const PrintedValue* printed = printedValue(record, value.name);
      html.row({value.name, valueWithUnit(value.value, value.unit),
                printed ? valueWithUnit(printed->value, value.unit) : "no number printed",
                printed ? comparisonText(*printed, value) : ""});
    }
    html.raw("</table>\n");
  }
  html.element("p", "Printed: " + std::string(record.source) + ".");
  if (!record.differences.empty()) html.element("p", "Differences: " + std::string(record.differences));
  if (const std::string text = substitutionText(record, inputs); !text.empty()) html.element("p", text);
  for (const std::string& remark : result.remarks) html.element("p", remark);
  html.element("p", "Time: " + shortText(result.seconds, 3) + " s" + (result.isKept ? ", of an earlier run." : "."));
  if (result.materials.empty()) return;
  html.raw("<details><summary>Materials and their hashes (SHA-256)</summary><table>\n");
  for (const UsedMaterial& material : result.materials) html.row({material.name, material.file, material.sha256});
  html.raw("</table></details>\n");
}

}  // namespace

std::vector<UsedMaterial> usedMaterials(std::span<const InputMaterial> materials, Inputs& inputs) {
  std::vector<UsedMaterial> used;
  for (const InputMaterial& material : materials) {
    const bool isFile = std::filesystem::exists(material.path);
    used.push_back({shownName(material),
                    isFile ? std::filesystem::path(material.path).filename().string() : material.path,
                    inputs.hash(material)});
  }
  return used;
}

std::string figureKey(const FigureRecord& record, std::span<const UsedMaterial> materials, bool quick) {
  OrderedJson key{{"figure", record.id}, {"version", study::buildFacts().version}, {"quick", quick}, {"seed", runSeed}};
  for (const UsedMaterial& material : materials) key["materials"].push_back(material.sha256);
  return io::sha256Hex(io::jsonText(key));
}

void writeFigure(const std::filesystem::path& folder, const FigureResult& result, const MadeFigure& made,
                 const std::string& key) {
  const auto pdf = figures::figurePdf(made.drawing);
  io::CsvTable table = made.table;
  table.comments.insert(table.comments.begin(), result.record->name() + ": " + std::string(result.record->title));
  for (const UsedMaterial& material : result.materials)
    table.comments.push_back("material: " + material.name + ", SHA-256 " + material.sha256);
  const std::string csv = io::toCsv(table), svg = figures::figureSvg(made.drawing);
  const std::string json = io::jsonText(resultJson(result, key), 2) + "\n";
  const auto content = [&](const char* suffix, const std::string& text) {
    return io::FileContent{fileOfFigure(folder, *result.record, suffix), std::as_bytes(std::span(text))};
  };
  const std::vector<io::FileContent> files{{fileOfFigure(folder, *result.record, ".pdf"), pdf},
                                           content(".csv", csv),
                                           content(".svg", svg),
                                           content(".json", json)};
  io::writeFilesAtomically(files);
}

std::optional<FigureResult> keptFigure(const std::filesystem::path& folder, const FigureRecord& record,
                                       const std::string& key) {
  for (const char* suffix : figureSuffixes)
    if (!std::filesystem::exists(fileOfFigure(folder, record, suffix))) return std::nullopt;
  try {
    const auto json = io::parseJson(io::readText(fileOfFigure(folder, record, ".json")));
    if (json.at("key") != key) return std::nullopt;
    FigureResult result{.record = &record, .seconds = json.at("seconds"), .isKept = true};
    for (const auto& value : json.at("values"))
      result.values.push_back(
          {value.at("name"), value.at("unit"), value.at("value").is_null() ? std::nan("") : double(value.at("value"))});
    for (const auto& remark : json.at("remarks")) result.remarks.push_back(remark);
    for (const auto& material : json.at("materials"))
      result.materials.push_back({material.at("name"), material.at("file"), material.at("sha256")});
    return result;
  } catch (const std::exception&) {
    return std::nullopt;  // damaged or of another version: made again
  }
}

const PrintedValue* printedValue(const FigureRecord& record, std::string_view name) {
  const auto found = std::ranges::find(record.printed, name, &PrintedValue::name);
  return found == record.printed.end() ? nullptr : &*found;
}

std::string comparisonText(const PrintedValue& printed, const ReproducedValue& value) {
  const double difference = value.value - printed.value;
  if (!std::isfinite(difference)) return "undefined";
  if (difference == 0) return "equal";
  const bool isBetter = (difference > 0) != printed.lowerIsBetter;
  return std::string(isBetter ? "better" : "worse") + " by " + valueWithUnit(std::abs(difference), value.unit);
}

std::string reportHtml(const Inputs& inputs, std::span<const FigureResult> results) {
  Html html;
  html.raw(pageHead).element("h1", "Reproduction of Tongbuasirilai 2023");
  html.element("p",
               "Tongbuasirilai, Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition, 2023: its "
               "figures and tables made by Gonio from the materials below, beside the printed values.");
  if (inputs.folder(MaterialSet::merl).empty())
    html.raw(
        "<p class=\"note\"><b>No MERL files were given: near-measured copies stand for them.</b> They are neural "
        "fits, smoother than the measurements. Give the folder of the files with --merl.</p>\n");
  if (inputs.quick())
    html.raw(
        "<p class=\"note\"><b>Quick run:</b> four materials where a figure uses whole sets, small pictures, few "
        "samples.</p>\n");
  html.raw("<ul>\n");
  for (const std::string& line : inputs.origins()) html.element("li", line);
  for (const std::string& line : study::machineLines(study::machineFacts())) html.element("li", line);
  html.element("li", "seed of all random numbers: " + std::to_string(runSeed));
  html.raw("</ul>\n");
  addComparisons(html, results);
  for (const FigureResult& result : results) addFigure(html, result, inputs);
  return html.raw("</body></html>\n").str();
}

}  // namespace gonio::reproduction
