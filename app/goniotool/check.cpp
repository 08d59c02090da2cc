// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cstdio>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/metrics/plausibility.h"

namespace gonio::tool {

namespace {

int check(const std::string& file, const Tool& tool) {
  const materials::Material material = documents::openMaterial(file, tool.control("reading"));
  const std::vector<metrics::PlausibilityCheck> checks =
      metrics::checkPlausibility(*material.brdf, tool.control("checking"));
  Json list = Json::array();
  std::string text, failures;
  for (const std::string& note : material.source.notes) text += "note: " + note + "\n";
  for (const metrics::PlausibilityCheck& one : checks) {
    list.push_back({{"name", one.name}, {"passed", one.passed}, {"worst", one.worst}, {"where", one.where}});
    const std::string worst = "worst " + number(one.worst) + (one.where.empty() ? "" : " at " + one.where);
    text += one.name + (one.passed ? ": passed, " : ": FAILED, ") + worst + "\n";
    if (!one.passed) failures += (failures.empty() ? "" : "; ") + one.name + " fails (" + worst + ")";
  }
  print(tool, {{"passed", failures.empty()}, {"checks", list}, {"notes", material.source.notes}}, text);
  if (failures.empty()) return 0;
  throw Error(file + ": not plausible: " + failures);
}

}  // namespace

void addCheck(CLI::App& app, Tool& tool) {
  const auto file = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("check", "Checks plausibility: reciprocity, energy, negative, non-finite and missing values");
  command->add_option("MATERIAL", *file, materialHelp)->required();
  command->callback([file, &tool] { tool.run = [file, &tool] { return check(*file, tool); }; });
}

}  // namespace gonio::tool
