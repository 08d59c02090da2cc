// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_measurement.h"

#include <algorithm>
#include <chrono>

#include "core/documents/open_material.h"
#include "core/figures/figure_number.h"
#include "core/rendering/error_maps.h"
#include "core/study/accuracy_study.h"

namespace gonio::figures {

namespace {

/// Fraction of a material's progress that reading takes.
constexpr double readingShare = 0.1;

std::vector<const FigureNumber*> numbersOf(const FigureDescription& description) {
  std::vector<const FigureNumber*> numbers;
  for (const std::string& id : description.numbers) numbers.push_back(&figureNumber(id));
  return numbers;
}

study::StudyOptions studyOptions(const FigureDescription& description) {
  study::StudyOptions options;
  const FigurePictures& pictures = description.pictures;
  options.picture.width = options.picture.height = pictures.size;
  options.picture.samples = pictures.samples;
  options.scene = figureScene(pictures);
  const auto numbers = numbersOf(description);
  options.timed = std::ranges::any_of(numbers, [](const FigureNumber* number) { return number->isTimed; });
  return options;
}

FigureRow measureRow(const FigureMaterial& shown, const FigureDescription& description, study::StudyOptions options,
                     const TaskControl& control) {
  const materials::Material material = editing::openMaterial(shown.path, control.between(0, 0.5 * readingShare));
  const auto table = material.tabulated(control.between(0.5 * readingShare, readingShare));
  FigureRow row{.name = shown.label.empty() ? material.name : shown.label, .reference = {}, .cells = {}};
  const auto numbers = numbersOf(description);
  options.referenceRendered = [&](const Image& picture) { row.reference = picture; };
  options.measured = [&](const study::StudiedRepresentation& studied) {
    FigureCell& cell = row.cells.emplace_back();
    cell.picture = studied.picture;
    for (const FigureNumber* number : numbers) cell.numbers.push_back(number->value(studied, row.reference));
  };
  std::vector<study::Representation> representations;
  for (const FigureRepresentation& one : description.representations) representations.push_back(one.representation);
  study::runStudy({table, material.brdf}, representations, options, control.between(readingShare, 1));
  if (row.cells.size() < representations.size()) throw Cancelled();
  return row;
}

double commonErrorMaximum(const std::vector<FigureRow>& rows) {
  double maximum = 0;
  for (const FigureRow& row : rows) {
    std::vector<Image> pictures;
    for (const FigureCell& cell : row.cells) pictures.push_back(cell.picture);
    maximum = std::max(maximum, errorRange(row.reference, pictures));
  }
  return maximum;
}

}  // namespace

FigureMeasurement measureFigure(const FigureDescription& description, const TaskControl& control) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  checkFigure(description);
  const study::StudyOptions options = studyOptions(description);
  FigureMeasurement measurement;
  const double fraction = 1 / double(description.materials.size());
  for (const FigureMaterial& material : description.materials) {
    const double begin = fraction * double(measurement.rows.size());
    measurement.rows.push_back(
        measureRow(material, description, options, control.between(begin, std::min(1.0, begin + fraction))));
  }
  measurement.errorMaximum =
      description.errorMaximum ? *description.errorMaximum : commonErrorMaximum(measurement.rows);
  measurement.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return measurement;
}

}  // namespace gonio::figures
