// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <array>

#include "app/goniotool/materials.h"
#include "app/goniotool/measure_factors.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/acquisition/measured_values.h"
#include "core/acquisition/sampling_plan.h"

namespace gonio::tool {

namespace {

struct MeasureArguments {
  std::string material, plan, out;
  acquisition::MeasurementNoise noise;
  double misalignmentDegrees = 0;
};

int measure(MeasureArguments options, const Tool& tool) {
  const acquisition::SamplingPlan plan = acquisition::readPlan(options.plan);
  const materials::Material material = openMaterial(options.material, tool.control("reading"));
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
          "Instead of a plan, measure two curves over these axes and predict the material: projected-deviation, "
          "symmetric-deviation, half-difference or half-out")
      ->check(CLI::IsMember(namesOf(acquisition::factorAxesNames)));
  command
      .add_option("--fixed-angle", options->fixedDegrees,
                  "Angle (theta_R, theta_d or theta_o, the first axis) at which the readings around the mirror "
                  "direction are taken, degrees (60)")
      ->check(CLI::Range(0.0, 89.9));
  command
      .add_option("--angles", options->angles, "Number of readings in the mirror direction, one for each angle (90)")
      ->check(CLI::Range(2, 2000));
  command
      .add_option("--distances", options->distances,
                  "Number of readings at different distances from the mirror direction (90)")
      ->check(CLI::Range(2, 2000));
  command.add_option("--max-polar", options->maxPolarDegrees, "Max. polar angle of both arms, degrees (89)")
      ->check(CLI::Range(0.1, 89.9));
  command.add_option("--min-separation", options->minSeparationDegrees, "Min. angle between the arms, degrees (2)")
      ->check(CLI::Range(0.0, 180.0));
  command.add_option("--values", options->values, "CSV file of the readings of both curves, instead of a simulation");
  command.add_option("--predict", options->predict,
                     outputHelp("File to write: the predicted material") + ", or its factors (.pdv)");
  command
      .add_option("--bound", options->bound,
                  "Upper bound of the prediction: readings or none. readings applies two limits to the product of "
                  "the curves: the larger of the interpolated readings at the same angle (in the mirror direction) and "
                  "at the same distance (around it), and the value with light and viewer exchanged (readings)")
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
  return measureFactors(factors, tool);
}

}  // namespace

void addMeasure(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<MeasureArguments>();
  const auto factors = std::make_shared<MeasureFactorsArguments>();
  CLI::App* command = app.add_subcommand(
      "measure",
      "Simulates the measurement of a material with a goniometer, at the directions of a plan or along two curves");
  command->add_option("MATERIAL", options->material, materialHelp);
  command->add_option("--plan", options->plan, "CSV file of a plan, see goniotool plan");
  command->add_option("--out", options->out,
                      "CSV file to write: index and r, g, b in 1/sr; with --factors also the directions; with noise "
                      "also its standard deviations");
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
