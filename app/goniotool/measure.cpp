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
  CLI::App* command = app.add_subcommand("measure", "A material at the directions of a plan, as a goniometer reads it");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--plan", options->plan, "CSV that goniotool plan has written")->required();
  command->add_option("--out", options->out, "CSV to write: index, r, g, b in 1/sr")->required();
  command->add_option("--noise", options->noise.relative, "Standard deviation of a reading, a share of it (0)")
      ->check(CLI::Range(0.0, 100.0));
  command->add_option("--floor", options->noise.absolute, "Standard deviation beside that, 1/sr (0)")
      ->check(CLI::Range(0.0, 1e6));
  command
      ->add_option("--misalignment", options->misalignmentDegrees,
                   "Standard deviation of each arm along each of two axes, degrees (0)")
      ->check(CLI::Range(0.0, 90.0));
  command->add_option("--seed", options->noise.seed, "Of the errors (1)");
  command->callback([options, &tool] { tool.run = [options, &tool] { return measure(*options, tool); }; });
}

}  // namespace gonio::tool
