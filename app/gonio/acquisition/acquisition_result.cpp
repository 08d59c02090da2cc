// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_result.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/gonio/acquisition/acquisition_planner.h"
#include "app/gonio/library/thumbnail.h"
#include "core/materials/material.h"
#include "core/metrics/brdf_metrics.h"
#include "core/rendering/error_maps.h"
#include "core/support/error.h"
#include "widgets/preview/gl/preview_comparison.h"

namespace gonio::app {

namespace {

constexpr int comparedSide = 192, comparedSamples = 32;
constexpr int maxCounts = 12;

/// What a picture of comparisonScene() shows, on a transparent ground.
QImage withoutSurroundings(const Image& picture) {
  Image sphere = picture;
  for (std::size_t i = 0; i < sphere.pixels.size(); ++i)
    if (sphere.alpha[i] < 0.5f) sphere.pixels[i] = glm::vec3(0), sphere.alpha[i] = 0;
  return displayedImage(sphere);
}

AcquisitionError errorOf(const TabulatedBrdf& table, const rendering::ComparisonPicture& picture,
                         const AcquisitionReference& reference) {
  return {reference.comparison->signalToNoiseRatio(picture),
          metrics::brdfError(metrics::BrdfMetric::log, *reference.table, table)};
}

void addErrorMap(ComparedPicture& result, const Image& picture, const Image& against) {
  result.errorRange =
      widgets::automaticRange(widgets::pictureDifferences(picture, against, widgets::DifferenceKind::absolute));
  result.errorMap = QImage(picture.width, picture.height, QImage::Format_ARGB32_Premultiplied);
  result.errorMap.fill(Qt::transparent);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
      if (std::max(picture.alpha[i], against.alpha[i]) < 0.5f) continue;
      const double difference = luminance(Rgb(picture.pixels[i])) - luminance(Rgb(against.pixels[i]));
      const rendering::DisplayColour colour = rendering::viridis(std::abs(difference) / result.errorRange);
      result.errorMap.setPixel(x, y, qRgb(colour[0], colour[1], colour[2]));
    }
}

}  // namespace

rendering::RenderOptions acquisitionPicture() {
  return {.width = comparedSide, .height = comparedSide, .samples = comparedSamples, .density = {}};
}

AcquisitionReferencePtr acquisitionReference(const QString& id, const QString& name,
                                             std::shared_ptr<const TabulatedBrdf> table,
                                             const rendering::RenderOptions& picture, const TaskControl& control) {
  auto reference = std::make_shared<AcquisitionReference>();
  reference->id = id;
  reference->name = name;
  reference->table = std::move(table);
  reference->comparison = std::make_unique<const rendering::RenderedComparison>(*reference->table, picture, control);
  reference->picture = withoutSurroundings(reference->comparison->reference());
  return reference;
}

AcquisitionReferencePtr readAcquisitionReference(const QString& id, const rendering::RenderOptions& picture,
                                                 const TaskControl& control) {
  constexpr double readFraction = 0.6;
  const materials::Material material = materials::readMaterial(id.toStdString(), control.between(0, readFraction / 2));
  auto table = meanOfOrders(material.tabulated(control.between(readFraction / 2, readFraction)));
  return acquisitionReference(id, QString::fromStdString(material.name), std::move(table), picture,
                              control.between(readFraction, 1));
}

ComparedPicture comparedPicture(const TabulatedBrdf& table, const AcquisitionReferencePtr& reference,
                                const TaskControl& control) {
  ComparedPicture result;
  if (!reference) {
    result.picture = spherePicture(table, comparedSide, comparedSamples, control);
    return result;
  }
  const rendering::ComparisonPicture picture = reference->comparison->render(table, control);
  result.picture = withoutSurroundings(picture.image);
  result.error = errorOf(table, picture, *reference);
  addErrorMap(result, picture.image, reference->comparison->reference());
  return result;
}

AcquisitionInput AcquisitionInput::prefix(std::size_t samples) const {
  AcquisitionInput part = *this;
  part.plan.samples.resize(std::min(samples, plan.samples.size()));
  part.values.rgb.resize(std::min(samples, values.rgb.size()));
  part.values.noise.resize(std::min(samples, values.noise.size()));
  return part;
}

AcquisitionResultPtr acquire(const AcquisitionInput& input, const AcquisitionReferencePtr& reference,
                             const TaskControl& control) {
  constexpr double reconstructedFraction = 0.5;
  auto result = std::make_shared<AcquisitionResult>();
  auto reconstruction = std::make_shared<const acquisition::Reconstruction>(acquisition::reconstruct(
      *input.basis, input.plan, input.values, input.options, control.between(0, reconstructedFraction)));
  result->reconstruction = reconstruction;
  static_cast<ComparedPicture&>(*result) =
      comparedPicture(*reconstruction->table, reference, control.between(reconstructedFraction, 1));
  std::vector<double> deviations(reconstruction->standardDeviation.begin(), reconstruction->standardDeviation.end());
  if (!deviations.empty()) result->deviationRange = widgets::automaticRange(std::move(deviations));
  return result;
}

std::vector<int> curveCounts(int m) {
  std::set<int> counts;
  for (int k = 1; k <= maxCounts; ++k) counts.insert(std::max(1, int(std::lround(double(m) * k / maxCounts))));
  return {counts.begin(), counts.end()};
}

void measureCurve(const AcquisitionInput& input, const AcquisitionReferencePtr& reference,
                  const std::function<void(int samples, const AcquisitionError& error)>& measured,
                  const TaskControl& control) {
  const std::vector<int> counts = curveCounts(int(input.plan.samples.size()));
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double done = double(i) / double(counts.size()), next = double(i + 1) / double(counts.size());
    const TaskControl part = control.between(done, next);
    AcquisitionInput first = input.prefix(std::size_t(counts[i]));
    first.options.uncertainty = false;
    const auto reconstruction =
        acquisition::reconstruct(*first.basis, first.plan, first.values, first.options, part.between(0, 0.5));
    const rendering::ComparisonPicture picture =
        reference->comparison->render(*reconstruction.table, part.between(0.5, 1));
    measured(counts[i], errorOf(*reconstruction.table, picture, *reference));
  }
}

FactorResultPtr predictFromSimulation(const FactorSettings& settings, const AcquisitionReferencePtr& reference,
                                      const TaskControl& control) {
  acquisition::FactorReadings readings{.plan = acquisition::planFactors(settings.plan), .values = {}};
  readings.values = acquisition::measure(*reference->table, readings.plan.plan, settings.noise);
  return predictFromReadings(readings, settings.bound, reference, control);
}

FactorResultPtr predictFromReadings(const acquisition::FactorReadings& readings, acquisition::FactorBound bound,
                                    const AcquisitionReferencePtr& reference, const TaskControl& control) {
  constexpr double predictedFraction = 0.5;
  auto result = std::make_shared<FactorResult>();
  result->readings = readings;
  result->curves = acquisition::factorMeasurement(readings.plan, readings.values);
  result->support = acquisition::supportOf(result->curves);
  result->table =
      bakeTable(*acquisition::predictFromFactors(result->curves, bound),
                reference ? reference->table->grid() : HalfDifferenceGrid(), control.between(0, predictedFraction));
  static_cast<ComparedPicture&>(*result) =
      comparedPicture(*result->table, reference, control.between(predictedFraction, 1));
  return result;
}

FactorReadingsFile readFactorReadings(const QString& path, acquisition::FactorAxes axes) {
  FactorReadingsFile file{path, acquisition::readFactorReadings(path.toStdString(), axes), {}};
  const auto named = acquisition::axesOfFactorMethod(file.readings.plan.plan.method);
  try {
    return withAxes(std::move(file), named.value_or(axes));
  } catch (const Error& error) {
    if (named) throw;
    throw Error(
        std::string(error.what()) +
        "\nThe file does not state its axes (comment \"# method: factors, AXES\"), so the selected ones were used. "
        "Select the axes of the readings, then open the file again.");
  }
}

FactorReadingsFile withAxes(FactorReadingsFile file, acquisition::FactorAxes axes) {
  return withFileInErrors(file.path.toStdString(), [&] {
    file.readings.plan.axes = axes;
    file.readings.plan.plan.method = acquisition::factorMethod(axes);
    file.curves = acquisition::factorMeasurement(file.readings.plan, file.readings.values);
    return file;
  });
}

}  // namespace gonio::app
