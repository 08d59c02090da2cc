// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_description.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/documents/open_material.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/io/json_text.h"
#include "core/metrics/brdf_metric.h"
#include "core/metrics/image_errors.h"
#include "core/rendering/environment.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene_file.h"
#include "core/support/error.h"
#include "core/support/json_object.h"
#include "core/support/text.h"

namespace gonio::figures {

namespace {

using study::MeasuredRepresentation;

void addImageMetrics(std::vector<FigureNumber>& numbers) {
  for (const metrics::ImageMetricRecord& metric : metrics::imageMetricRecords())
    numbers.push_back(
        {.id = std::string(metric.id),
         .name = std::string(metric.name),
         .unit = "",
         .better = metric.higherIsBetter ? Better::higher : Better::lower,
         .value = [compute = metric.compute](const MeasuredRepresentation& studied, const Image& reference) {
           return compute(reference, studied.picture);
         }});
}

void addBrdfMetrics(std::vector<FigureNumber>& numbers) {
  const auto metrics = metrics::metricRecords();
  for (std::size_t i = 0; i < metrics.size(); ++i)
    numbers.push_back(
        {.id = std::string(metrics[i].id),
         .name = std::string(metrics[i].id),
         .unit = std::string(metrics[i].unit),
         .value = [i](const MeasuredRepresentation& studied, const Image&) { return studied.record.errors[i]; }});
}

void addCosts(std::vector<FigureNumber>& numbers) {
  using S = const MeasuredRepresentation&;
  const auto add = [&](const char* id, const char* name, const char* unit, bool isTimed, auto value) {
    numbers.push_back({.id = id,
                       .name = name,
                       .unit = unit,
                       .isError = false,
                       .isTimed = isTimed,
                       .value = [value](S studied, const Image&) { return double(value(studied.record)); }});
  };
  using R = const study::StudyRecord&;
  add("bytes", "size", "B", false, [](R record) { return record.bytes; });
  add("encoding-time", "encoding", "s", true, [](R record) { return record.encodeSeconds; });
  add("evaluation-time", "evaluation", "s", true, [](R record) { return 1e-9 * record.evaluation.median; });
  add("frame-time", "frame", "s", true, [](R record) { return 1e-3 * record.frameMilliseconds; });
}

std::vector<FigureNumber> makeNumbers() {
  std::vector<FigureNumber> numbers{
      {.id = "rendered-snr",
       .name = "SNR",
       .unit = "dB",
       .better = Better::higher,
       .value = [](const MeasuredRepresentation& studied, const Image&) { return studied.record.renderedSnr; }}};
  addImageMetrics(numbers);
  addBrdfMetrics(numbers);
  addCosts(numbers);
  return numbers;
}

/// Three significant digits; whole numbers from 1000 on.
std::string digitsOf(double value) {
  constexpr int digits = 3;
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
  if (std::abs(value) >= 1000) return std::to_string(std::llround(value));
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%#.*g", digits, value);
  std::string result(text, std::size_t(length));
  if (result.ends_with('.')) result.pop_back();
  return value == 0 ? "0" : result;
}

}  // namespace

std::string FigureNumber::title() const { return unit.empty() ? name : name + " [" + unit + "]"; }

std::span<const FigureNumber> figureNumbers() {
  static const std::vector<FigureNumber> numbers = makeNumbers();
  return numbers;
}

const FigureNumber& figureNumber(std::string_view id) {
  const auto found = std::ranges::find(figureNumbers(), id, &FigureNumber::id);
  if (found != figureNumbers().end()) return *found;
  std::string known;
  for (const FigureNumber& number : figureNumbers()) known += (known.empty() ? "" : ", ") + number.id;
  throw Error("found the quantity '" + std::string(id) + "', expected one of " + known);
}

std::string tableText(const FigureNumber& number, double value) {
  return number.unit == "B" && std::isfinite(value) ? std::to_string(std::llround(value)) : digitsOf(value);
}

std::string valueText(const FigureNumber& number, double value) {
  struct Prefix {
    double factor;
    const char* letter;
  };
  constexpr Prefix prefixes[] = {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}};
  const std::string unit = number.unit.empty() ? "" : " " + number.unit;
  if (number.isError || !std::isfinite(value) || value == 0) return digitsOf(value) + unit;
  // A value that rounds to 1000 has the next prefix.
  constexpr double rounding = 0.9995;
  if (number.unit == "B" && value < 1000) return tableText(number, value) + unit;
  const auto prefix = std::ranges::find_if(prefixes, [&](const Prefix& one) { return value >= rounding * one.factor; });
  const Prefix used = prefix == std::end(prefixes) ? prefixes[std::size(prefixes) - 1] : *prefix;
  return digitsOf(value / used.factor) + " " + used.letter + number.unit;
}

namespace {

namespace fs = std::filesystem;

constexpr std::string_view formatName = "gonio figure";

std::string textOr(const JsonObject& object, std::string_view key, const std::string& otherwise) {
  return object.contains(key) ? object.text(key) : otherwise;
}

double numberOr(const JsonObject& object, std::string_view key, double min, double max, double otherwise) {
  return object.contains(key) ? object.number(key, min, max) : otherwise;
}

int integerOr(const JsonObject& object, std::string_view key, int min, int max, int otherwise) {
  const double number = numberOr(object, key, min, max, otherwise);
  if (number != int(number))
    object.fail(key, "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
  return int(number);
}

/// The one of two texts that a member has, by its number.
int choiceOr(const JsonObject& object, std::string_view key, std::string_view first, std::string_view second,
             int otherwise) {
  if (!object.contains(key)) return otherwise;
  const std::string text = object.text(key);
  if (text != first && text != second)
    object.fail(key, "\"" + std::string(first) + "\" or \"" + std::string(second) + "\"");
  return text == second;
}

/// Reads each element of a list that holds 1 to `most`.
template <typename Read>
void eachOf(const JsonObject& root, std::string_view key, std::size_t most, const Read& read) {
  const nlohmann::json& list = root.array(key);
  if (list.empty() || list.size() > most) root.fail(key, "a list of 1 to " + std::to_string(most));
  for (std::size_t i = 0; i < list.size(); ++i) read(list[i], root.place(key) + "[" + std::to_string(i) + "]");
}

FigureMaterial materialFrom(const nlohmann::json& json, const std::string& where) {
  const JsonObject object(json, where);
  object.expectOnly({"path", "label"});
  if (object.text("path").empty()) object.fail("path", "a file or library:SOURCE/NAME");
  return {object.text("path"), textOr(object, "label", "")};
}

FigureRepresentation representationFrom(const nlohmann::json& json, const std::string& where) {
  const JsonObject object(json, where);
  object.expectOnly({"id", "budget", "label"});
  std::optional<double> budget;
  if (object.contains("budget")) budget = object.number("budget", 0, 1e9);
  try {
    return {study::representationById(object.text("id"), budget), textOr(object, "label", "")};
  } catch (const Error& error) {
    throw Error(where + ": " + error.what());
  }
}

std::string numberFrom(const nlohmann::json& json, const std::string& where) {
  if (!json.is_string()) throw Error(where + ": found " + describeJson(json) + ", expected the name of a quantity");
  try {
    return figureNumber(json.get<std::string>()).id;
  } catch (const Error& error) {
    throw Error(where + ": " + error.what());
  }
}

FigurePictures picturesFrom(const JsonObject& object) {
  object.expectOnly({"scene", "environment", "size", "samples", "exposure", "toneMap"});
  FigurePictures pictures;
  pictures.scene = textOr(object, "scene", "");
  pictures.environment = textOr(object, "environment", "");
  pictures.size = integerOr(object, "size", 1, FigurePictures::maxSize, pictures.size);
  pictures.samples = integerOr(object, "samples", 1, FigurePictures::maxSamples, pictures.samples);
  pictures.exposure = numberOr(object, "exposure", -FigurePictures::maxExposure, FigurePictures::maxExposure, 0);
  pictures.toneMap = rendering::ToneMap(choiceOr(object, "toneMap", rendering::toneMapName(rendering::ToneMap::clamp),
                                                 rendering::toneMapName(rendering::ToneMap::filmic), 0));
  return pictures;
}

FigureInset insetFrom(const JsonObject& object) {
  object.expectOnly({"x", "y", "size"});
  FigureInset inset;
  inset.size = object.number("size", FigureInset::minSize, 1);
  inset.x = object.number("x", 0, 1 - inset.size);
  inset.y = object.number("y", 0, 1 - inset.size);
  return inset;
}

nlohmann::ordered_json toJson(const FigurePictures& pictures) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!pictures.scene.empty()) json["scene"] = pictures.scene;
  if (!pictures.environment.empty()) json["environment"] = pictures.environment;
  json.update({{"size", pictures.size},
               {"samples", pictures.samples},
               {"exposure", pictures.exposure},
               {"toneMap", rendering::toneMapName(pictures.toneMap)}});
  return json;
}

/// Whether a text of a description names a file, not something bundled.
bool isFile(const std::string& name) {
  return !name.empty() && !name.starts_with("library:") && fs::path(name).has_extension();
}

/// All paths of a description: those of its materials, its scene and its environment.
template <typename Change>
void eachPath(FigureDescription& description, const Change& change) {
  for (FigureMaterial& material : description.materials)
    if (!material.path.starts_with("library:")) change(material.path);
  for (std::string* name : {&description.pictures.scene, &description.pictures.environment})
    if (isFile(*name)) change(*name);
}

}  // namespace

std::string FigureRepresentation::shownLabel() const {
  if (!label.empty()) return plainText(label);
  return representation.shortLabel();
}

std::string_view figureWidthId(FigureWidth width) { return width == FigureWidth::oneColumn ? "one" : "two"; }

nlohmann::ordered_json toJson(const FigureDescription& description) {
  nlohmann::ordered_json json{{"format", formatName}, {"version", FigureDescription::currentVersion}};
  if (!description.title.empty()) json["title"] = description.title;
  json["columns"] = figureWidthId(description.width);
  json["font"] = description.font;
  if (description.fontSize > 0) json["fontSize"] = description.fontSize;
  for (const FigureMaterial& material : description.materials) {
    nlohmann::ordered_json& one = json["materials"].emplace_back();
    one["path"] = material.path;
    if (!material.label.empty()) one["label"] = material.label;
  }
  for (const FigureRepresentation& representation : description.representations) {
    nlohmann::ordered_json& one = json["representations"].emplace_back();
    one["id"] = representation.representation.kind->id;
    if (representation.representation.kind->hasBudget()) one["budget"] = int(representation.representation.budget);
    if (!representation.label.empty()) one["label"] = representation.label;
  }
  json["pictures"] = toJson(description.pictures);
  json["numbers"] = description.numbers;
  if (description.inset)
    json["inset"] = {{"x", description.inset->x}, {"y", description.inset->y}, {"size", description.inset->size}};
  json["errorMaps"] = description.errorMaps;
  if (description.errorMaximum) json["errorMaximum"] = *description.errorMaximum;
  return json;
}

FigureDescription figureFromJson(const nlohmann::json& json) {
  const JsonObject root(json, "");
  if (root.text("format") != formatName) root.fail("format", "\"gonio figure\"");
  if (root.number("version", 1, 1e6) != FigureDescription::currentVersion)
    root.fail("version", "1, the only version that this program reads");
  root.expectOnly({"format", "version", "title", "columns", "font", "fontSize", "materials", "representations",
                   "pictures", "numbers", "inset", "errorMaps", "errorMaximum"});
  FigureDescription description;
  description.title = textOr(root, "title", "");
  description.width = FigureWidth(
      choiceOr(root, "columns", figureWidthId(FigureWidth::oneColumn), figureWidthId(FigureWidth::twoColumns), 1));
  description.font = textOr(root, "font", description.font);
  description.fontSize = numberOr(root, "fontSize", FigureDescription::minFontSize, FigureDescription::maxFontSize, 0);
  eachOf(root, "materials", FigureDescription::maxMaterials, [&](const nlohmann::json& one, const std::string& where) {
    description.materials.push_back(materialFrom(one, where));
  });
  eachOf(root, "representations", FigureDescription::maxRepresentations,
         [&](const nlohmann::json& one, const std::string& where) {
           description.representations.push_back(representationFrom(one, where));
         });
  if (root.contains("pictures")) description.pictures = picturesFrom(root.object("pictures"));
  if (root.contains("numbers")) {
    description.numbers.clear();
    if (!root.array("numbers").empty())
      eachOf(root, "numbers", FigureDescription::maxNumbers, [&](const nlohmann::json& one, const std::string& where) {
        description.numbers.push_back(numberFrom(one, where));
      });
  }
  if (root.contains("inset")) description.inset = insetFrom(root.object("inset"));
  if (root.contains("errorMaps")) description.errorMaps = root.flag("errorMaps");
  if (root.contains("errorMaximum"))
    description.errorMaximum =
        root.number("errorMaximum", FigureDescription::minErrorMaximum, FigureDescription::maxErrorMaximum);
  return description;
}

void checkFigure(const FigureDescription& description) { figureFromJson(toJson(description)); }

FigureDescription readFigureDescription(const fs::path& path) {
  return withFileInErrors(path, [&] {
    FigureDescription description = figureFromJson(io::parseJson(io::readText(path)));
    eachPath(description, [&](std::string& name) { name = (path.parent_path() / name).string(); });
    return description;
  });
}

std::string figureDescriptionText(const FigureDescription& description, const fs::path& path) {
  FigureDescription written = description;
  const fs::path folder = fs::weakly_canonical(fs::absolute(path).parent_path());
  eachPath(written, [&](std::string& name) {
    const fs::path absolute = fs::weakly_canonical(fs::absolute(name));
    const fs::path relative = absolute.lexically_relative(folder);
    name = relative.empty() || *relative.begin() == ".." ? absolute.string() : relative.generic_string();
  });
  return io::exactJsonText(toJson(written), 2) + "\n";
}

std::vector<std::string> figureSources(const FigureDescription& description) {
  FigureDescription copy = description;
  std::vector<std::string> sources;
  eachPath(copy, [&](const std::string& name) { sources.push_back(name); });
  return sources;
}

void checkFigureOutput(const FigureDescription& description, const fs::path& path) {
  for (const std::string& source : figureSources(description))
    if (io::isOneOf(path, documents::filesOf(source)))
      throw Error(path.string() + ": the figure is made from this file, expected another name");
}

rendering::Scene figureScene(const FigurePictures& pictures) {
  rendering::Scene scene =
      rendering::openScene(pictures.scene.empty() ? rendering::comparisonSceneName : pictures.scene);
  if (!pictures.environment.empty()) scene.environment = rendering::openEnvironment(pictures.environment);
  return scene;
}

}  // namespace gonio::figures
