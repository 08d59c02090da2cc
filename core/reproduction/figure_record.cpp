// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/reproduction/figure_record.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "core/support/error.h"

namespace gonio::reproduction {

std::span<const FigureRecord> allFigures() {
  static const std::vector<FigureRecord> figures = [] {
    std::vector<FigureRecord> all;
    for (const auto chapter :
         {statisticsFigures, factorFigures, dictionaryFigures, measurementFigures, acquisitionFigures})
      std::ranges::move(chapter(), std::back_inserter(all));
    // Tables of a chapter before its figures.
    std::ranges::stable_sort(all, {},
                             [](const FigureRecord& one) { return std::tuple(one.id.front(), !one.isTable, one.id); });
    return all;
  }();
  return figures;
}

std::vector<const FigureRecord*> selectedFigures(std::span<const std::string> ids) {
  std::string known;
  for (const FigureRecord& figure : allFigures()) known += (known.empty() ? "" : ", ") + std::string(figure.id);
  for (const std::string& id : ids)
    if (std::ranges::find(allFigures(), id, &FigureRecord::id) == allFigures().end())
      throw Error("found no figure or table " + id + ", expected one of " + known);
  std::vector<const FigureRecord*> selected;
  for (const FigureRecord& figure : allFigures())
    if (ids.empty() || std::ranges::count(ids, figure.id)) selected.push_back(&figure);
  return selected;
}

std::vector<InputMaterial> materialsOf(const FigureRecord& record, const Inputs& inputs) {
  std::vector<InputMaterial> materials;
  for (const Subject& subject : record.subjects) materials.push_back(inputs.find(subject));
  if (inputs.quick()) {
    std::ranges::copy(inputs.testMaterials(record.wholeSets), std::back_inserter(materials));
  } else {
    for (const MaterialSet set : record.wholeSets)
      std::ranges::copy(inputs.materials(set), std::back_inserter(materials));
  }
  if (record.isLearned) std::ranges::copy(inputs.trainingMaterials(), std::back_inserter(materials));
  return materials;
}

}  // namespace gonio::reproduction
