// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_measurement.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/documents/open_material.h"
#include "core/figures/figure_description.h"
#include "core/rendering/error_maps.h"
#include "core/study/accuracy_study.h"
#include "core/support/text.h"

namespace gonio::figures {

namespace {

namespace fs = std::filesystem;

/// Fraction of a material's progress that reading takes.
constexpr double readingFraction = 0.1;

bool showsTimes(const FigureDescription& description) {
  return std::ranges::any_of(description.numbers, [](const std::string& id) { return figureNumber(id).isTimed; });
}

bool isComparisonScene(const FigurePictures& pictures) {
  constexpr std::string_view names[] = {"", rendering::comparisonSceneName, rendering::bundledComparisonScene};
  return pictures.environment.empty() && std::ranges::find(names, pictures.scene) != std::end(names);
}

study::StudyOptions studyOptions(const FigureDescription& description) {
  study::StudyOptions options;
  const FigurePictures& pictures = description.pictures;
  rendering::RenderOptions shown;
  shown.width = shown.height = pictures.size;
  shown.samples = pictures.samples;
  // In the scene of all comparisons, the numbers are those of the study, whatever the size of the pictures.
  if (isComparisonScene(pictures)) {
    options.shown = shown;
  } else {
    options.picture = shown;
    options.scene = figureScene(pictures);
  }
  options.timed = showsTimes(description);
  return options;
}

using FileTimes = decltype(FigureMeasurement::fileTimes);

FileTimes fileTimesOf(const FigureDescription& description) {
  FileTimes times;
  for (const std::string& source : figureSources(description))
    for (const fs::path& file : documents::filesOf(source)) {
      std::error_code ignored;  // reading the file reports the error
      times[source].push_back(fs::last_write_time(file, ignored));
    }
  return times;
}

std::string nameOfPath(const std::string& path) {
  return path.starts_with("library:") ? path.substr(path.rfind('/') + 1) : fs::path(path).stem().string();
}

FigureCell measuredCell(const study::MeasuredRepresentation& studied, const Image& reference, bool timed) {
  FigureCell cell{.representation = studied.record.representation, .picture = studied.picture, .isTimed = timed};
  for (const FigureNumber& number : figureNumbers())
    cell.values.push_back(number.isTimed && !timed ? std::numeric_limits<double>::quiet_NaN()
                                                   : number.value(studied, reference));
  return cell;
}

/// The representations of a row that are not measured, without duplicates.
std::vector<study::Representation> missingOf(const FigureRow& row, const FigureDescription& description) {
  std::vector<study::Representation> missing;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const study::Representation& one = description.representations[i].representation;
    if (!row.cells[i] && std::ranges::find(missing, one) == missing.end()) missing.push_back(one);
  }
  return missing;
}

/// Measures the missing cells of a row.
void completeRow(FigureRow& row, const FigureDescription& description, study::StudyOptions options,
                 const std::function<void()>& measured, const TaskControl& control) {
  const materials::Material material = documents::openMaterial(row.path, control.between(0, 0.5 * readingFraction));
  const auto table = material.tabulated(control.between(0.5 * readingFraction, readingFraction));
  row.name = material.name;
  options.referenceRendered = [&](const Image& picture) { row.reference = std::make_shared<const Image>(picture); };
  options.measured = [&](const study::MeasuredRepresentation& studied) {
    const auto cell = std::make_shared<const FigureCell>(measuredCell(studied, *row.reference, options.timed));
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      if (!row.cells[i] && description.representations[i].representation == cell->representation) row.cells[i] = cell;
    if (measured) measured();
  };
  study::runStudy({table, material.brdf}, missingOf(row, description), options, control.between(readingFraction, 1));
  if (!row.isComplete()) throw Cancelled();
}

}  // namespace

double FigureCell::value(std::string_view number) const {
  return values[std::size_t(&figureNumber(number) - figureNumbers().data())];
}

bool FigureRow::isComplete() const {
  return reference && std::ranges::none_of(cells, [](const auto& cell) { return cell == nullptr; });
}

std::size_t FigureMeasurement::missingCells() const {
  std::size_t missing = 0;
  for (const FigureRow& row : rows) missing += std::size_t(std::ranges::count(row.cells, nullptr));
  return missing;
}

bool rendersTheSame(FigurePictures a, const FigurePictures& b) {
  a.exposure = b.exposure;
  a.toneMap = b.toneMap;
  return a == b;
}

FigureMeasurement knownPart(const FigureDescription& description, const FigureMeasurement& known) {
  FigureMeasurement part{.pictures = description.pictures, .fileTimes = fileTimesOf(description)};
  const auto timeOf = [](const FigureMeasurement& measurement, const std::string& path) {
    const auto found = measurement.fileTimes.find(path);
    return found == measurement.fileTimes.end() ? FileTimes::mapped_type() : found->second;
  };
  const auto unchanged = [&](const std::string& path) { return timeOf(part, path) == timeOf(known, path); };
  const bool samePictures = rendersTheSame(description.pictures, known.pictures) &&
                            unchanged(description.pictures.scene) && unchanged(description.pictures.environment);
  const bool timed = showsTimes(description);
  for (const FigureMaterial& material : description.materials) {
    FigureRow& row = part.rows.emplace_back();
    row.path = material.path;
    row.name = nameOfPath(material.path);
    row.cells.resize(description.representations.size());
    const auto found = std::ranges::find(known.rows, material.path, &FigureRow::path);
    if (!samePictures || found == known.rows.end() || !unchanged(material.path)) continue;
    row.name = found->name;
    row.reference = found->reference;
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      for (const auto& cell : found->cells)
        if (cell && cell->representation == description.representations[i].representation && (cell->isTimed || !timed))
          row.cells[i] = cell;
  }
  return part;
}

FigureMeasurement measureFigure(const FigureDescription& description, const TaskControl& control,
                                const MeasureFigureOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  checkFigure(description);
  const study::StudyOptions study = studyOptions(description);
  FigureMeasurement measurement = knownPart(description, options.known);
  const auto incomplete =
      std::ranges::count_if(measurement.rows, [](const FigureRow& row) { return !row.isComplete(); });
  const double fraction = 1 / double(std::max<std::ptrdiff_t>(1, incomplete));
  double begin = 0;
  for (FigureRow& row : measurement.rows) {
    if (row.isComplete()) continue;
    const double end = std::min(1.0, begin + fraction);
    completeRow(
        row, description, study,
        [&] {
          if (options.measured) options.measured(measurement);
        },
        control.between(begin, end));
    begin = end;
  }
  control.report(1);
  measurement.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return measurement;
}

std::string rowLabel(const FigureDescription& description, const FigureMeasurement& measurement, std::size_t row) {
  const std::string& label = description.materials[row].label;
  return plainText(label.empty() ? measurement.rows[row].name : label);
}

double errorMaximum(const FigureDescription& description, const FigureMeasurement& measurement) {
  if (description.errorMaximum) return *description.errorMaximum;
  double maximum = 0;
  for (const FigureRow& row : measurement.rows) {
    std::vector<Image> pictures;
    for (const auto& cell : row.cells)
      if (cell) pictures.push_back(cell->picture);
    if (row.reference && !pictures.empty())
      maximum = std::max(maximum, rendering::errorRange(*row.reference, pictures));
  }
  return maximum;
}

}  // namespace gonio::figures
