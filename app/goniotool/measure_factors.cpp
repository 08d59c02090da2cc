// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/measure_factors.h"

#include <functional>
#include <optional>

#include "app/goniotool/factor_quality.h"
#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "core/acquisition/factor_plan.h"
#include "core/formats/formats.h"
#include "core/formats/pdv.h"
#include "core/metrics/brdf_metrics.h"

namespace gonio::tool {

namespace {

using namespace acquisition;

FactorPlan planOf(const MeasureFactorsArguments& options) {
  return planFactors({.axes = factorAxesNamed(options.axes),
                      .fixedAngle = radians(options.fixedDegrees),
                      .angles = options.angles,
                      .distances = options.distances,
                      .maxPolarAngle = radians(options.maxPolarDegrees),
                      .minSeparation = radians(options.minSeparationDegrees)});
}

/// From the file, or of the material.
acquisition::FactorReadings readingsOf(const MeasureFactorsArguments& options,
                                       const std::optional<materials::Material>& material) {
  if (!options.values.empty()) return acquisition::readFactorReadings(options.values, factorAxesNamed(options.axes));
  acquisition::FactorReadings readings{.plan = planOf(options), .values = {}};
  readings.values = measure(*material->brdf, readings.plan.plan, options.noise);
  return readings;
}

/// Without readings: the directions alone.
int writeDirections(const MeasureFactorsArguments& options, const Tool& tool) {
  if (options.out.empty()) throw UsageError("measure: --factors needs at least one of MATERIAL, --values and --out");
  if (!options.predict.empty()) throw UsageError("measure: --predict needs MATERIAL or --values");
  const FactorPlan plan = planOf(options);
  acquisition::writeFactorReadings(plan, {}, options.out);
  print(tool,
        {{"axes", options.axes}, {"samples", plan.curves.size()}, {"blocked", plan.blocked}, {"out", options.out}},
        options.out + ": " + std::to_string(plan.curves.size()) + " directions to measure; add the columns r, g, b\n");
  return 0;
}

/// Computes the prediction and returns what writes it. Factors are the two curves themselves if the prediction is their
/// product over theta_R and |Dp|; otherwise they approximate it.
std::function<WrittenMaterial()> preparePrediction(const MeasureFactorsArguments& options,
                                                   const FactorMeasurement& curves, const Brdf& predicted,
                                                   const Tool& tool, Json& json, std::string& text) {
  json["predicted"] = options.predict;
  const auto table = bakeTable(predicted, HalfDifferenceGrid(), tool.control("predicting"));
  if (materials::hasSuffixOf(formats::pdvFormat, options.predict)) {
    const bool isProduct =
        curves.axes == FactorAxes::projectedDeviation && factorBoundNamed(options.bound) == FactorBound::none;
    const factorization::PdvFactors factors =
        isProduct ? pdvFactorsOfCurves(curves)
                  : factorization::factorizePdv(*table, {}, tool.control("factorising the prediction")).factors;
    json["terms"] = factors.terms();
    text += options.predict +
            (isProduct ? ": the two curves as one term\n" : ": " + std::to_string(factors.terms()) + " terms, ");
    if (!isProduct) {
      const double snr = metrics::brdfSignalToNoiseRatio(*table, *factorization::makePdvBrdf(factors));
      json["factorsSnr"] = decibelsJson(snr);
      text += "BRDF SNR " + number(snr) + " dB against the prediction\n";
    }
    return [factors, path = options.predict] {
      formats::writePdv(factors, path);
      return WrittenMaterial();
    };
  }
  text += options.predict + ": the predicted material\n";
  return [table, &tool, path = options.predict] { return writeMaterial("prediction", table, path, tool); };
}

Json supportJson(const FactorMeasurement& curves, const FactorSupport& support) {
  return {{"contradicted", support.contradicted},
          {"extrapolated", support.extrapolated},
          {"bounded", support.bounded},
          {"unscaled", {curves.unscaled[0], curves.unscaled[1], curves.unscaled[2]}},
          {"warnings", support.warnings}};
}

void checkOutputsOf(const MeasureFactorsArguments& options) {
  if (!options.values.empty() && !options.out.empty())
    throw UsageError("measure: --values and --out cannot be used together: the readings are already in a file");
  if (!options.predict.empty() && !materials::hasSuffixOf(formats::pdvFormat, options.predict))
    materials::checkWritableSuffix(options.predict);
}

}  // namespace

int measureFactors(const MeasureFactorsArguments& options, const Tool& tool) {
  checkOutputsOf(options);
  if (options.material.empty() && options.values.empty()) return writeDirections(options, tool);
  std::optional<materials::Material> material;
  if (!options.material.empty()) material = openMaterial(options.material, tool.control("reading"));
  const acquisition::FactorReadings readings = readingsOf(options, material);
  const FactorMeasurement curves = factorMeasurement(readings.plan, readings.values);
  const FactorSupport support = supportOf(curves);
  const auto predicted = predictFromFactors(curves, factorBoundNamed(options.bound));

  Json json{{"axes", options.axes},
            {"fixedAngle", degrees(curves.fixedAngle)},
            {"samples", readings.plan.curves.size()},
            {"along", curves.angles.size()},
            {"across", curves.distances.size()},
            {"blocked", readings.plan.blocked},
            {"bound", options.bound},
            {"support", supportJson(curves, support)}};
  std::string text = std::to_string(curves.angles.size()) + " readings in the mirror direction, " +
                     std::to_string(curves.distances.size()) + " around it at " + number(degrees(curves.fixedAngle)) +
                     " degrees";
  text += readings.plan.blocked > 0
              ? ", " + std::to_string(readings.plan.blocked) + " left out (unreachable by the rig)\n"
              : "\n";
  std::function<WrittenMaterial()> writePrediction;
  if (!options.predict.empty()) writePrediction = preparePrediction(options, curves, *predicted, tool, json, text);
  if (material) {
    const FactorQuality quality = factorQuality(*material, *predicted, smallComparisonPicture().samples, tool);
    addQuality(json, quality);
    text += "prediction: BRDF SNR " + number(quality.brdfSnr) + " dB, rendered SNR " + number(quality.renderedSnr) +
            " dB\n" + errorsText(quality.errors);
  }
  for (const std::string& warning : support.warnings) text += "warning: " + warning + "\n";
  // Files last: an interrupted command leaves none.
  if (!options.out.empty()) {
    acquisition::writeFactorReadings(readings.plan, readings.values, options.out);
    json["out"] = options.out;
  }
  if (writePrediction) {
    const WrittenMaterial written = writePrediction();
    if (written.bytes > 0) json["written"] = written.json();
    text += written.text;
  }
  print(tool, json, text);
  return 0;
}

}  // namespace gonio::tool
