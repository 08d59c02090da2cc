// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/acquisition/factor_plan.h"
#include "core/acquisition/factor_prediction.h"
#include "core/acquisition/measured_values.h"
#include "core/acquisition/sampling_plan.h"
#include "core/formats/formats.h"
#include "core/formats/pdv.h"
#include "core/metrics/brdf_metrics.h"

namespace gonio::tool {

namespace {

using namespace acquisition;

/// Options of `goniotool measure --factors`.
struct MeasureFactorsArguments {
  std::string material;  ///< empty: none
  std::string axes, values, out, predict, bound{acquisition::factorBoundNames[0]};
  double fixedDegrees = 60, maxPolarDegrees = 89, minSeparationDegrees = 2;
  int angles = 90, distances = 90;
  acquisition::MeasurementNoise noise;
};

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

/// Simulates the readings of both curves of a material, or reads them from a file; predicts the material, and measures
/// the error if the material is given. Without material and readings, writes the directions to measure. @throws
/// UsageError for contradictory options.
int measureCurves(const MeasureFactorsArguments& options, const Tool& tool) {
  checkOutputsOf(options);
  if (options.material.empty() && options.values.empty()) return writeDirections(options, tool);
  std::optional<materials::Material> material;
  if (!options.material.empty()) material = documents::openMaterial(options.material, tool.control("reading"));
  const acquisition::FactorReadings readings = readingsOf(options, material);
  const FactorMeasurement curves = factorMeasurement(readings.plan, readings.values);
  const FactorSupport support = supportOf(curves);
  const auto predicted = predictFromFactors(curves, factorBoundNamed(options.bound));

  const auto further = std::size_t(std::ranges::count(readings.plan.curves, FactorCurve::further));
  Json json{{"axes", options.axes},
            {"fixedAngle", degrees(curves.fixedAngle)},
            {"samples", readings.plan.curves.size()},
            {"along", curves.angles.size()},
            {"across", curves.distances.size()},
            {"further", further},
            {"blocked", readings.plan.blocked},
            {"bound", options.bound},
            {"support", supportJson(curves, support)}};
  std::string text = std::to_string(curves.angles.size()) + " readings in the mirror direction, " +
                     std::to_string(curves.distances.size()) + " around it at " + number(degrees(curves.fixedAngle)) +
                     " degrees";
  if (further > 0) text += ", " + std::to_string(further) + " at other angles";
  text += readings.plan.blocked > 0
              ? ", " + std::to_string(readings.plan.blocked) + " left out (unreachable by the rig)\n"
              : "\n";
  std::function<WrittenMaterial()> writePrediction;
  if (!options.predict.empty()) writePrediction = preparePrediction(options, curves, *predicted, tool, json, text);
  if (material) {
    const study::MaterialQuality quality =
        qualityOf(*material, *predicted, nullptr, rendering::smallComparisonPicture().samples, tool);
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

struct MeasureArguments {
  std::string material, plan, out;
  acquisition::MeasurementNoise noise;
  double misalignmentDegrees = 0;
};

int measure(MeasureArguments options, const Tool& tool) {
  const acquisition::SamplingPlan plan = acquisition::readPlan(options.plan);
  const materials::Material material = documents::openMaterial(options.material, tool.control("reading"));
  options.noise.misalignment = radians(options.misalignmentDegrees);
  const acquisition::MeasuredValues values = acquisition::measure(*material.brdf, plan, options.noise);
  acquisition::writeValues(plan, values, options.out);
  print(tool, {{"samples", values.rgb.size()}, {"out", options.out}},
        options.out + ": " + std::to_string(values.rgb.size()) + " samples of " + material.name + "\n");
  return 0;
}

constexpr std::array factorsOptions{"--fixed-angle",    "--angles", "--distances", "--max-polar",
                                    "--min-separation", "--values", "--predict",   "--bound"};

template <std::size_t count>
std::vector<std::string> namesOf(const std::array<std::string_view, count>& names) {
  return {names.begin(), names.end()};
}

/// The options of --factors.
void addFactorsOptions(CLI::App& command, const std::shared_ptr<MeasureFactorsArguments>& options) {
  command
      .add_option(
          "--factors", options->axes,
          "Instead of a plan, measure two curves and predict the material. adaptive fits it to all readings, also at "
          "further angles (for 60 readings or more); projected-deviation, symmetric-deviation, half-difference and "
          "half-out predict it as a product of two curves over these axes")
      ->check(CLI::IsMember(namesOf(acquisition::factorAxesNames)));
  command
      .add_option("--fixed-angle", options->fixedDegrees,
                  "Angle (theta_R, theta_d or theta_o, the first axis) at which the readings around the mirror "
                  "direction are taken, degrees (60)")
      ->check(CLI::Range(0.0, 89.9));
  command
      .add_option(
          "--angles", options->angles,
          "Number of readings in the mirror direction, one for each angle; with adaptive axes only the sum with "
          "--distances counts (90)")
      ->check(CLI::Range(2, 2000));
  command
      .add_option("--distances", options->distances,
                  "Number of readings at different distances from the mirror direction (90)")
      ->check(CLI::Range(2, 2000));
  command.add_option("--max-polar", options->maxPolarDegrees, "Max. polar angle of both arms, degrees (89)")
      ->check(CLI::Range(0.1, 89.9));
  command.add_option("--min-separation", options->minSeparationDegrees, "Min. angle between the arms, degrees (2)")
      ->check(CLI::Range(0.0, 180.0));
  command.add_option("--values", options->values, "CSV file of the readings of both curves, instead of a simulation")
      ->type_name("FILE");
  command
      .add_option("--predict", options->predict,
                  outputHelp("File to write: the predicted material") + ", or its factors (.pdv)")
      ->group(outputGroup);
  command
      .add_option(
          "--bound", options->bound,
          "Upper bound of the prediction: readings or none. readings limits the prediction by the larger of the "
          "interpolated readings at the same angle (in the mirror direction) and at the same distance (around "
          "it), and (not with adaptive axes) by the value with light and viewer exchanged (readings)")
      ->check(CLI::IsMember(namesOf(acquisition::factorBoundNames)));
}

int measureBy(const CLI::App& command, const MeasureArguments& options, MeasureFactorsArguments factors,
              const Tool& tool) {
  if (factors.axes.empty()) {
    for (const char* name : factorsOptions)
      if (command.count(name) > 0) throw UsageError(std::string("measure: ") + name + " needs --factors");
    if (options.material.empty() || options.plan.empty() || options.out.empty())
      throw UsageError("measure: expected MATERIAL, --plan and --out, or --factors");
    return measure(options, tool);
  }
  if (!options.plan.empty()) throw UsageError("measure: --plan cannot be used with --factors");
  factors.material = options.material;
  factors.out = options.out;
  factors.noise = options.noise;
  factors.noise.misalignment = radians(options.misalignmentDegrees);
  return measureCurves(factors, tool);
}

}  // namespace

void addMeasure(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<MeasureArguments>();
  const auto factors = std::make_shared<MeasureFactorsArguments>();
  CLI::App* command = app.add_subcommand(
      "measure",
      "Simulates the measurement of a material with a goniometer, at the directions of a plan or along two curves");
  command->add_option("MATERIAL", options->material, materialHelp);
  command->add_option("--plan", options->plan, "CSV file of a plan, see goniotool plan")->type_name("FILE");
  command
      ->add_option("--out", options->out,
                   "CSV file to write: index and r, g, b in 1/sr; with --factors also the directions; with noise "
                   "also its standard deviations")
      ->group(outputGroup);
  addFactorsOptions(*command, factors);
  command
      ->add_option("--noise", options->noise.relative,
                   "Standard deviation of a reading as a fraction of its value; 0.01 is 1 % (0)")
      ->check(CLI::Range(0.0, 100.0));
  command
      ->add_option("--floor", options->noise.absolute,
                   "Noise floor: standard deviation of a reading in the dark, 1/sr (0)")
      ->check(CLI::Range(0.0, 1e6));
  command
      ->add_option("--misalignment", options->misalignmentDegrees,
                   "Standard deviation of the misalignment of each arm, about each of two axes, degrees (0)")
      ->check(CLI::Range(0.0, 90.0));
  command->add_option("--seed", options->noise.seed, "Seed of the random errors (1)");
  command->callback([=, &tool] { tool.run = [=, &tool] { return measureBy(*command, *options, *factors, tool); }; });
}

}  // namespace gonio::tool
