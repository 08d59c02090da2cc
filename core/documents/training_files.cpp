// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/documents/training_files.h"

#include <algorithm>
#include <filesystem>

#include "core/documents/open_material.h"
#include "core/materials/material_formats.h"

namespace gonio::editing {

std::string trainingHelp() {
  return "Folders of " + materials::suffixText(materials::isMeasurement, "and") + " files, or files";
}

std::vector<std::string> trainingFiles(const std::vector<std::string>& sources,
                                       const std::vector<std::string>& excluded) {
  std::vector<std::string> files;
  for (const std::string& source : sources) {
    if (!std::filesystem::is_directory(source)) {
      files.push_back(source);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(source))
      if (const auto* format = materials::formatOfFile(entry.path()); format && format->isMeasurement)
        found.push_back(entry.path().string());
    if (found.empty())
      throw Error(source + ": found no file of a measured material, expected " +
                  materials::suffixText(materials::isMeasurement, "or"));
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  // A name that excludes nothing would teach what is to be held out.
  for (const std::string& name : excluded)
    if (std::erase_if(files, [&](const std::string& file) { return std::filesystem::path(file).stem() == name; }) == 0)
      throw Error("found no material " + name + " to leave out of the training");
  if (files.empty()) throw Error("no material is left to learn from");
  return files;
}

dictionary::TrainingMaterials trainingMaterials(const std::vector<std::string>& files) {
  dictionary::TrainingMaterials materials;
  for (const std::string& file : files) materials.names.push_back(std::filesystem::path(file).stem().string());
  materials.load = [files](std::size_t m) {
    auto table = openMaterial(files[m]).tabulated();
    if (!(table->grid() == HalfDifferenceGrid{}))
      throw Error(files[m] + ": found another grid than that of MERL tables, 90 x 90 x 180");
    return table;
  };
  return materials;
}

}  // namespace gonio::editing
