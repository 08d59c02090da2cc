// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/bases.h"

#include <chrono>

#include "core/io/sha256.h"
#include "core/materials/material_formats.h"
#include "core/study/training_files.h"
#include "core/support/error.h"

namespace gonio::tool {

std::shared_ptr<const materials::BasisFile> learnBasis(const std::vector<std::string>& sources,
                                                       const std::vector<std::string>& excluded, int maxComponents,
                                                       const Tool& tool, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  const auto materials = study::trainingMaterials(study::trainingFilesOrLibrary(sources, excluded));
  auto basis = std::make_shared<materials::BasisFile>();
  basis->components = dictionary::learnPrincipalComponents(
      materials.names.size(), materials.load, {.maxComponents = maxComponents},
      tool.control("learning from " + std::to_string(materials.names.size()) + " materials"));
  basis->learnedFrom = materials.names;
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return basis;
}

std::string trainingSetHelp(const std::string& title) {
  return title + ": " + materials::suffixText(materials::isMeasurement, "or") + " files, or folders of them";
}

std::filesystem::path basisBeside(const std::string& plan) {
  return std::filesystem::path(plan).replace_extension(materials::basisSuffix);
}

std::string basisDigest(const std::filesystem::path& basis) {
  return withFileInErrors(basis, [&] { return io::sha256Hex(io::FileSource(basis)).substr(0, 16); });
}

}  // namespace gonio::tool
