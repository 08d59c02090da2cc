// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/training_files.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "core/documents/open_material.h"
#include "core/materials/bundled_library.h"
#include "core/materials/material_formats.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::study {

namespace {

std::string cellsText(const HalfDifferenceGrid& grid) {
  return std::to_string(grid.thetaHCount) + " x " + std::to_string(grid.thetaDCount) + " x " +
         std::to_string(grid.phiDCount) + (grid.reciprocal ? " cells" : " cells with phi_d from 0 to 360 degrees");
}

}  // namespace

std::string trainingHelp() {
  return "Measured materials (" + materials::suffixText(materials::isMeasurement, "and") + " files) or folders of them";
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
      throw Error("found no material " + name + " to exclude from the training set");
  if (files.empty()) throw Error("no material is left in the training set");
  return files;
}

std::vector<std::string> trainingFilesOrLibrary(const std::vector<std::string>& sources,
                                                const std::vector<std::string>& excluded) {
  return trainingFiles(sources.empty() ? materials::libraryTrainingPaths() : sources, excluded);
}

HalfDifferenceGrid trainingGrid(const std::vector<std::string>& files) {
  const materials::Material first = documents::openMaterial(files.front());
  const TabulatedBrdf* table = formOf<TabulatedBrdf>(*first.brdf);
  return table ? table->grid() : HalfDifferenceGrid();
}

dictionary::TrainingMaterials trainingMaterials(const std::vector<std::string>& files, const HalfDifferenceGrid& grid,
                                                TrainingOrders orders) {
  dictionary::TrainingMaterials materials;
  materials.grid = grid;
  for (const std::string& file : files) materials.names.push_back(std::filesystem::path(file).stem().string());
  materials.load = [files, grid, orders](std::size_t m) {
    auto table = documents::openMaterial(files[m]).tabulated();
    const bool hasBothOrders = orders == TrainingOrders::both && !table->isReciprocal();
    if (grid.reciprocal && !hasBothOrders) table = meanOfOrders(table);
    if (!(table->grid() == (hasBothOrders ? grid.wholeCircle() : grid)))
      throw Error(files[m] + ": found a table of " + cellsText(table->grid()) + ", expected " + cellsText(grid) +
                  " as for all materials of the training set");
    return table;
  };
  return materials;
}

MaterialClass materialClassNamed(std::string_view name) {
  const auto found = std::ranges::find(materialClassNames, name);
  if (found == materialClassNames.end())
    throw Error("class of materials: found '" + std::string(name) + "', expected all, diffuse or glossy");
  return MaterialClass(found - materialClassNames.begin());
}

double highlightContrast(const Brdf& material) {
  double largest = 0;
  for (const double angle : {15.0, 30.0, 45.0}) {
    const Direction light = fromSpherical(radians(angle), 0);
    const double mirror = luminance(material.evaluate(light, fromSpherical(radians(angle), pi)));
    const double beside = luminance(material.evaluate(light, fromSpherical(radians(angle), halfPi)));
    if (!(mirror > 0)) continue;
    largest = std::max(largest, beside > 0 ? mirror / beside : std::numeric_limits<double>::infinity());
  }
  return largest;
}

std::vector<std::string> filesOfClass(const std::vector<std::string>& files, MaterialClass materialClass,
                                      const TaskControl& control) {
  if (materialClass == MaterialClass::all) return files;
  std::vector<char> isGlossy(files.size());
  parallelForBlocks(
      files.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          isGlossy[i] = highlightContrast(*documents::openMaterial(files[i]).brdf) >= glossyContrast;
      },
      control);
  std::vector<std::string> result;
  for (std::size_t i = 0; i < files.size(); ++i)
    if ((isGlossy[i] != 0) == (materialClass == MaterialClass::glossy)) result.push_back(files[i]);
  if (result.empty())
    throw Error("no material of the training set is " + std::string(materialClassNames[std::size_t(materialClass)]));
  return result;
}

std::vector<std::size_t> photographClasses(const photograph::PhotographPrior& prior) {
  std::vector<std::size_t> classes(prior.trainingCount());
  parallelForBlocks(classes.size(), 1, [&](std::size_t m, std::size_t) {
    const auto table = dictionary::tableOfCells(prior.mapping, cellValues(prior, prior.trainingCoefficients(m)));
    classes[m] = highlightContrast(*table) >= glossyContrast ? 1 : 0;
  });
  return classes;
}

}  // namespace gonio::study
