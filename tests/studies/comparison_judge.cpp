// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/comparison_judge.h"

#include <algorithm>
#include <cctype>

#include "core/materials/material.h"
#include "core/metrics/brdf_metrics.h"

namespace gonio::study {

std::string collectionOf(const std::filesystem::path& file) {
  std::string name = file.parent_path().filename().string();
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return name;
}

ComparisonJudge::ComparisonJudge(const std::filesystem::path& file, std::string collection,
                                 const rendering::RenderOptions& picture)
    : material_(file.stem()),
      collection_(std::move(collection)),
      table_(meanOfOrders(materials::readMaterial(file).tabulated())),
      comparison_(*table_, picture) {}

ComparisonRecord ComparisonJudge::score(const std::string& model, const baselines::ComparedModel& built,
                                        double seconds) const {
  const rendering::ComparisonPicture picture = comparison_.render(*built.brdf);
  return {.material = material_,
          .collection = collection_,
          .model = model,
          .bytes = built.bytes,
          .rendered = comparison_.signalToNoiseRatio(picture),
          .peak = comparison_.peakSignalToNoiseRatio(picture),
          .reflectance = metrics::brdfSignalToNoiseRatio(*table_, *built.brdf),
          .seconds = seconds};
}

}  // namespace gonio::study
