// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/factor_baseline.h"

#include <array>
#include <chrono>

#include "app/goniotool/factor_quality.h"
#include "app/goniotool/materials.h"
#include "core/baselines/baselines.h"
#include "core/formats/formats.h"

namespace gonio::tool {

std::vector<std::string> baselineIds() {
  std::vector<std::string> ids;
  for (const factorization::Baseline& baseline : factorization::baselines()) ids.emplace_back(baseline.id);
  return ids;
}

int factorByBaseline(const FactorBaselineArguments& options, const Tool& tool) {
  if (materials::hasSuffixOf(formats::pdvFormat, options.out))
    throw UsageError("factor: " + options.method + " has no factor file: --out must be a table (.binary)");
  if (!options.out.empty()) materials::checkWritableSuffix(options.out);
  const factorization::Baseline& baseline = factorization::findBaseline(options.method);
  const materials::Material material = openMaterial(options.material, tool.control("reading"));
  const auto table = material.tabulated(tool.control("tabulating"));
  const auto start = std::chrono::steady_clock::now();
  const std::array<std::size_t, 1> budgets{options.bytes};
  const factorization::ComparedModel model =
      baseline.build(*table, budgets, tool.control("factorising " + material.name)).front();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const FactorQuality quality = factorQuality(material, *model.brdf, options.samples, tool);
  WrittenMaterial written;
  if (!options.out.empty()) written = writeMaterial(material.name, model.brdf, options.out, tool, table->grid());
  Json json{{"method", options.method},
            {"reference", baseline.reference},
            {"byteBudget", options.bytes},
            {"bytes", model.bytes},
            {"seconds", seconds}};
  addQuality(json, quality);
  const std::string tableText = addTableQuality(json, *material.brdf, *table);
  if (!options.out.empty()) {
    json["written"] = written.json();
    json["out"] = options.out;
  }
  print(tool, json,
        options.method + " (" + std::string(baseline.name) + "), " + std::to_string(model.bytes) + " bytes, " +
            qualityText(quality, seconds) + tableText + written.text);
  return 0;
}

}  // namespace gonio::tool
