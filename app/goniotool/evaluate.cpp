// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <chrono>

#include "app/goniotool/direction_table.h"
#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/brdf/brdf.h"
#include "core/io/atomic_file.h"

namespace gonio::tool {

namespace {

struct EvaluateArguments {
  std::string material, directions, out;
  bool asStored = false;
  double wavelength = 0;
};

int evaluate(const EvaluateArguments& options, const Tool& tool) {
  const auto material = openAtWavelength(options.material, options.wavelength, tool.control("reading"));
  const DirectionTable directions = readDirections(options.directions);
  const std::vector<DirectionPair> pairs = directions.pairs();
  std::vector<Rgb> values(pairs.size());
  const auto brdf = options.asStored ? withIncident(material, IncidentDirection::light) : material;
  const auto start = std::chrono::steady_clock::now();
  brdf->evaluate(pairs, values);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  tool.throwIfStopped();
  io::writeFileAtomically(options.out, valuesCsv(directions, values));
  const double evaluationNs = seconds * 1e9 / double(values.size());
  print(
      tool, {{"evaluated", values.size()}, {"seconds", seconds}, {"evaluationNs", evaluationNs}, {"out", options.out}},
      options.out + ": " + std::to_string(values.size()) + " values, " + number(evaluationNs) + " ns per evaluation\n");
  return 0;
}

}  // namespace

void addEvaluate(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<EvaluateArguments>();
  CLI::App* command = app.add_subcommand("evaluate", "Evaluates the BRDF at given directions");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--directions", options->directions, "CSV file with theta_i, phi_i, theta_o, phi_o in degrees")
      ->required();
  command->add_option("--out", options->out, "CSV file to write: the directions, then the BRDF values r, g, b in 1/sr")
      ->required();
  command->add_flag(
      "--as-stored", options->asStored,
      "Interpret the incident direction of an RGL or UTIA file as that of the light (default: that of the viewer)");
  command->add_option("--wavelength", options->wavelength, wavelengthHelp)->check(CLI::Range(1.0, 1e6));
  command->callback([options, &tool] { tool.run = [options, &tool] { return evaluate(*options, tool); }; });
}

}  // namespace gonio::tool
