// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/near_measured_library.h"

#include <algorithm>
#include <cstdio>

#include "core/brdf/neural_brdf.h"
#include "core/io/sha256.h"
#include "core/materials/library_list.h"
#include "core/materials/measured_library.h"

extern "C" {
// NeuralBrdf::weightCount numbers per material, in the order of the list (bundled_files.S).
extern const float gonioNearMeasured[];
}

namespace gonio::materials {

namespace {

std::string databaseOf(const std::string& source) {
  std::string name = source.substr(0, source.find('-'));
  std::ranges::transform(name, name.begin(), [](char c) { return char(c - 'a' + 'A'); });
  return name;
}

}  // namespace

std::string NearMeasuredMaterial::description() const {
  std::string text = "near-measured copy of " + databaseOf(source) + " " + name +
                     ": neural fit of the measurement, Sztrajman et al. 2021";
  if (!renderedSnr) return text;
  char number[64];
  std::snprintf(number, sizeof number, "; rendered SNR against the measurement %.1f dB", *renderedSnr);
  return text + number;
}

std::string NearMeasuredMaterial::sha256() const { return io::sha256Hex(io::MemorySource(std::as_bytes(weights))); }

const std::vector<NearMeasuredMaterial>& nearMeasuredMaterials() {
  static const std::vector<NearMeasuredMaterial> materials = [] {
    std::vector<NearMeasuredMaterial> result;
    for (const LibraryRow& row : libraryRows()) {
      if (row.source != merlCopySource && row.source != rglCopySource && row.source != dtuCopySource) continue;
      const float* weights = gonioNearMeasured + result.size() * NeuralBrdf::weightCount;
      result.push_back({row.source, row.name, row.renderedSnr, {weights, NeuralBrdf::weightCount}});
    }
    return result;
  }();
  return materials;
}

bool isOriginalBundled(const NearMeasuredMaterial& copy) {
  return copy.source == rglCopySource &&
         std::ranges::any_of(measuredMaterials(), [&](const MeasuredMaterial& one) { return one.name == copy.name; });
}

Material nearMeasuredMaterial(const NearMeasuredMaterial& copy, const TaskControl& control) {
  Material material;
  material.name = copy.name;
  material.table = bakeTable(NeuralBrdf(copy.weights), {}, control);
  material.brdf = material.table;
  material.source.format = nearMeasuredFormat;
  material.source.sha256 = copy.sha256();
  material.source.description = copy.description();
  const HalfDifferenceGrid& grid = material.table->grid();
  material.source.grid = {grid.thetaHCount, grid.thetaDCount, grid.phiDCount};
  return material;
}

}  // namespace gonio::materials
