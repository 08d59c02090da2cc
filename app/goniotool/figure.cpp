// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <charconv>
#include <cmath>
#include <filesystem>
#include <list>
#include <optional>
#include <set>

#include "app/goniotool/outputs.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/documents/open_material.h"
#include "core/figures/figure_description.h"
#include "core/figures/figure_formats.h"
#include "core/figures/figure_tables.h"
#include "core/io/atomic_file.h"
#include "core/rendering/environment.h"

namespace gonio::tool {

namespace {

namespace fs = std::filesystem;
using namespace figures;

/// What stands on the command line; absent: as the description or its defaults have it.
struct FigureArguments {
  std::string description, save, csv, latex;
  std::vector<std::string> materials, representations, numbers, out;
  std::vector<double> inset;
  std::optional<std::string> title, columns, font, scene, environment, toneMap;
  std::optional<double> fontSize, exposure, errorMaximum;
  std::optional<int> size, samples;
  bool noErrorMaps = false, noNumbers = false;
  double dotsPerInch = figureDotsPerInch;
};

/// "factors-3d:10".
FigureRepresentation representationOf(const std::string& text) {
  const std::size_t colon = text.find(':');
  std::optional<double> budget;
  if (colon != std::string::npos) {
    const char *begin = text.data() + colon + 1, *const end = text.data() + text.size();
    int count = 0;
    const auto [at, error] = std::from_chars(begin, end, count);
    if (error != std::errc() || at != end)
      throw UsageError("--representations: found '" + text + "', expected ID or ID:BUDGET, such as factors-3d:10");
    budget = count;
  }
  return {study::representationById(text.substr(0, colon), budget)};
}

void applyPictures(const FigureArguments& options, FigurePictures& pictures) {
  if (options.scene) pictures.scene = *options.scene;
  if (options.environment) pictures.environment = *options.environment;
  if (options.size) pictures.size = *options.size;
  if (options.samples) pictures.samples = *options.samples;
  if (options.exposure) pictures.exposure = *options.exposure;
  if (options.toneMap)
    pictures.toneMap = *options.toneMap == rendering::toneMapName(rendering::ToneMap::filmic)
                           ? rendering::ToneMap::filmic
                           : rendering::ToneMap::clamp;
}

FigureDescription describe(const FigureArguments& options) {
  FigureDescription figure;
  if (!options.description.empty()) figure = readFigureDescription(options.description);
  if (!options.materials.empty()) {
    figure.materials.clear();
    for (const std::string& path : options.materials) figure.materials.push_back({path});
  }
  if (!options.representations.empty()) {
    figure.representations.clear();
    for (const std::string& text : options.representations) figure.representations.push_back(representationOf(text));
  }
  if (options.title) figure.title = *options.title;
  if (options.columns)
    figure.width =
        *options.columns == figureWidthId(FigureWidth::oneColumn) ? FigureWidth::oneColumn : FigureWidth::twoColumns;
  if (options.font) figure.font = *options.font;
  if (options.fontSize) figure.fontSize = *options.fontSize;
  if (!options.numbers.empty()) figure.numbers = options.numbers;
  if (options.noNumbers) figure.numbers.clear();
  if (!options.inset.empty()) figure.inset = FigureInset{options.inset[0], options.inset[1], options.inset[2]};
  if (options.noErrorMaps) figure.errorMaps = false;
  if (options.errorMaximum) figure.errorMaximum = options.errorMaximum;
  applyPictures(options, figure.pictures);
  if (figure.materials.empty() || figure.representations.empty())
    throw UsageError("figure: no " + std::string(figure.materials.empty() ? "materials" : "representations") +
                     " were given; use a DESCRIPTION, or --materials and --representations");
  checkFigure(figure);
  checkFigureFits(figure);
  return figure;
}

/// The names of all files to write.
std::vector<std::string> outputsOf(const FigureArguments& options) {
  std::vector<std::string> outputs = options.out;
  for (const std::string* name : {&options.save, &options.csv, &options.latex})
    if (!name->empty()) outputs.push_back(*name);
  return outputs;
}

/// Before the work: suffixes, folders, and that no output is a file of the figure or another output.
void checkOutputs(const FigureArguments& options, const FigureDescription& figure, const Tool& tool) {
  std::vector<fs::path> read;
  for (const std::string& source : figureSources(figure))
    for (const fs::path& file : documents::filesOf(source)) read.push_back(file);
  for (const std::string& name : options.out) figureFormatOf(name);
  std::set<fs::path> names;
  for (const std::string& name : outputsOf(options)) {
    if (!names.insert(fs::weakly_canonical(name)).second)
      throw UsageError("figure: two outputs have the same name " + name);
    if (!tool.force) checkOutput(name, read);
    io::checkWritable(name);
  }
}

/// Files in memory, which are written together.
class FigureFiles {
 public:
  void add(const std::string& path, std::vector<std::byte> content) {
    contents_.push_back(std::move(content));
    files_.push_back({path, contents_.back()});
  }
  void add(const std::string& path, const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    add(path, std::vector<std::byte>(bytes.begin(), bytes.end()));
  }
  void write() const { io::writeFilesAtomically(files_); }

 private:
  std::list<std::vector<std::byte>> contents_;
  std::vector<io::FileContent> files_;
};

Json recordsJson(const FigureDescription& figure, const FigureMeasurement& measurement) {
  Json records = Json::array();
  for (std::size_t row = 0; row < measurement.rows.size(); ++row)
    for (std::size_t cell = 0; cell < figure.representations.size(); ++cell) {
      Json numbers = Json::object();
      for (const std::string& id : figure.numbers)
        numbers[id] = decibelsJson(measurement.rows[row].cells[cell]->value(id));
      const FigureRepresentation& shown = figure.representations[cell];
      records.push_back({{"material", rowLabel(figure, measurement, row)},
                         {"representation", shown.representation.kind->id},
                         {"label", shown.shownLabel()},
                         {"budget", shown.representation.budget},
                         {"numbers", numbers}});
    }
  return records;
}

std::string recordsText(const FigureDescription& figure, const FigureMeasurement& measurement) {
  std::string text;
  for (std::size_t row = 0; row < measurement.rows.size(); ++row) {
    text += rowLabel(figure, measurement, row) + "\n";
    for (std::size_t cell = 0; cell < figure.representations.size(); ++cell) {
      text += "  " + figure.representations[cell].shownLabel();
      for (std::size_t i = 0; i < figure.numbers.size(); ++i) {
        const FigureNumber& number = figureNumber(figure.numbers[i]);
        text += (i ? ", " : ": ") + number.name + " " +
                valueText(number, measurement.rows[row].cells[cell]->value(number.id));
      }
      text += "\n";
    }
  }
  return text;
}

/// Measures a figure and adds its files; without pictures or tables to write, nothing is measured.
std::optional<FigureMeasurement> makeFigure(const FigureArguments& options, const FigureDescription& figure,
                                            FigureFiles& files, const Tool& tool) {
  if (options.out.empty() && options.csv.empty() && options.latex.empty()) return std::nullopt;
  const TaskControl control = tool.control("measuring the cells of the figure");
  FigureMeasurement measurement = measureFigure(figure, control);
  for (const std::string& name : options.out)
    files.add(name, figureFile(figure, measurement, figureFormatOf(name), options.dotsPerInch));
  if (!options.csv.empty()) files.add(options.csv, io::toCsv(figureCsv(figure, measurement)));
  if (!options.latex.empty()) files.add(options.latex, figureLatex(figure, measurement));
  control.throwIfStopped();
  return measurement;
}

int runFigure(const FigureArguments& options, const Tool& tool) {
  const std::vector<std::string> outputs = outputsOf(options);
  if (outputs.empty()) throw UsageError("figure: no output was given; use --out, --csv, --latex or --save");
  const FigureDescription figure = describe(options);
  checkOutputs(options, figure, tool);
  FigureFiles files;
  if (!options.save.empty()) files.add(options.save, figureDescriptionText(figure, options.save));
  const std::optional<FigureMeasurement> measurement = makeFigure(options, figure, files, tool);
  files.write();
  Json json{{"pictures", figurePicturesText(figure.pictures)}};
  std::string text;
  if (measurement) {
    json.update({{"records", recordsJson(figure, *measurement)},
                 {"errorMaximum", errorMaximum(figure, *measurement)},
                 {"seconds", measurement->seconds}});
    text = recordsText(figure, *measurement);
  }
  json["out"] = outputs;
  for (const std::string& name : outputs) text += name + "\n";
  print(tool, json, text);
  return 0;
}

void addContentOptions(CLI::App& command, FigureArguments& options) {
  command
      .add_option("--materials", options.materials, "Materials, one per row: files, documents or library:SOURCE/NAME")
      ->type_name("MATERIAL");
  command
      .add_option("--representations", options.representations,
                  "Representations, one per column: ID or ID:BUDGET, such as ggx factors-3d:10 code:256")
      ->type_name("ID");
  command
      .add_option(
          "--numbers", options.numbers,
          "Numbers under the images: rendered-snr, an image metric (listed by goniotool compare), a metric of BRDF "
          "values (see goniotool fit --sort), bytes, encoding-time, evaluation-time, frame-time "
          "(rendered-snr,bytes,evaluation-time)")
      ->type_name("ID")
      ->delimiter(',');
  command.add_flag("--no-numbers", options.noNumbers, "Leave out the numbers");
  command
      .add_option("--inset", options.inset,
                  "Magnified part: X Y SIZE in fractions of the image, from the top left (none)")
      ->expected(3);
  command.add_flag("--no-error-maps", options.noErrorMaps, "Leave out the error maps");
  command.add_option("--error-maximum", options.errorMaximum,
                     "Maximum of the scale of the error maps, luminance error (from the data)");
  command.add_option("--title", options.title, "Title above the figure (none)");
}

void addPageOptions(CLI::App& command, FigureArguments& options) {
  command
      .add_option("--columns", options.columns,
                  "Width of the figure: one column (84 mm) or two columns (177 mm) of a page (two)")
      ->check(CLI::IsMember({"one", "two"}));
  command.add_option("--font", options.font, "Font family (Helvetica, or its substitute)")->type_name("NAME");
  command.add_option("--font-size", options.fontSize, "Font size, pt (7 in one column, 8 in two)");
  command.add_option("--dpi", options.dotsPerInch, "Resolution of PNG files, dots per inch (300)")
      ->check(CLI::Range(36.0, 2400.0));
}

void addPictureOptions(CLI::App& command, FigureArguments& options) {
  command.add_option("--scene", options.scene, "Bundled scene, scene file or mesh (sphere)")->type_name("NAME|FILE");
  command
      .add_option(
          "--environment", options.environment,
          "Environment: " + rendering::bundledEnvironmentList() + " or an image file (environment of the scene)")
      ->type_name("NAME|FILE");
  command.add_option("--size", options.size, "Size of the images, pixels (256)");
  command.add_option("--samples", options.samples, "Samples per pixel (64)");
  command.add_option("--exposure", options.exposure, "Exposure of the images, stops (0)");
  command.add_option("--tone-map", options.toneMap, "Tone map of the images: clamp or filmic (clamp)")
      ->check(CLI::IsMember({std::string(rendering::toneMapName(rendering::ToneMap::clamp)),
                             std::string(rendering::toneMapName(rendering::ToneMap::filmic))}));
}

}  // namespace

void addFigure(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<FigureArguments>();
  CLI::App* command = app.add_subcommand(
      "figure",
      "Creates a figure for a paper: a grid of materials and representations with error maps, insets and numbers");
  command->add_option("DESCRIPTION", options->description,
                      "File that describes the figure; options override its settings");
  addContentOptions(*command, *options);
  addPictureOptions(*command, *options);
  addPageOptions(*command, *options);
  command->add_option("--out", options->out, "Figures to write: .pdf, .svg or .png; one or several")
      ->group(outputGroup);
  command->add_option("--csv", options->csv, "File for the numbers as CSV")->group(outputGroup);
  command->add_option("--latex", options->latex, "File for the numbers as a LaTeX table")->group(outputGroup);
  command->add_option("--save", options->save, "File for the description (.json), to create the figure again")
      ->group(outputGroup);
  command->callback([options, &tool] { tool.run = [options, &tool] { return runFigure(*options, tool); }; });
}

}  // namespace gonio::tool
