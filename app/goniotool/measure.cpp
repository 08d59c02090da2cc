// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/materials/plan_file.h"
#include "core/materials/values_file.h"

namespace gonio::tool {

namespace {

struct MeasureArguments {
  std::string material, plan, out;
  acquisition::MeasurementNoise noise;
  double misalignmentDegrees = 0;
};

int measure(MeasureArguments options, const Tool& tool) {
  const acquisition::SamplingPlan plan = materials::readPlan(options.plan);
  const materials::Material material = openMaterial(options.material, tool.control("reading"));
  options.noise.misalignment = radians(options.misalignmentDegrees);
  const acquisition::MeasuredValues values = acquisition::measure(*material.brdf, plan, options.noise);
  materials::writeValues(plan, values, options.out);
  print(tool, {{"samples", values.rgb.size()}, {"out", options.out}},
        options.out + ": " + std::to_string(values.rgb.size()) + " samples of " + material.name + "\n");
  return 0;
}

}  // namespace

void addMeasure(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<MeasureArguments>();
  CLI::App* command = app.add_subcommand(
      "measure", "Simulates the measurement of a material by a goniometer at the directions of a plan");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--plan", options->plan, "CSV file of a plan (from goniotool plan)")->required();
  command->add_option("--out", options->out, "CSV file to write: index, r, g, b, 1/sr")->required();
  command->add_option("--noise", options->noise.relative, "Relative standard deviation of a reading (0)")
      ->check(CLI::Range(0.0, 100.0));
  command
      ->add_option("--floor", options->noise.absolute,
                   "Noise floor: standard deviation of a reading in the dark, 1/sr (0)")
      ->check(CLI::Range(0.0, 1e6));
  command
      ->add_option("--misalignment", options->misalignmentDegrees,
                   "Standard deviation of the direction of each arm about each of two axes, degrees (0)")
      ->check(CLI::Range(0.0, 90.0));
  command->add_option("--seed", options->noise.seed, "Seed of the random errors (1)");
  command->callback([options, &tool] { tool.run = [options, &tool] { return measure(*options, tool); }; });
}

}  // namespace gonio::tool
