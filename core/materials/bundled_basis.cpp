// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/bundled_basis.h"

#include <algorithm>
#include <functional>
#include <mutex>

#include "core/brdf/neural_brdf.h"
#include "core/materials/bundled_library.h"

namespace gonio::materials {

namespace {

/// Of three a material. The others carry little information on any material, and would cost memory.
constexpr int components = 64;

void raise(std::vector<float>& largest, const TabulatedBrdf& table) {
  for (std::size_t cell = 0; cell < largest.size(); ++cell)
    largest[cell] = std::max(largest[cell], float(maxChannel(Rgb(table.values()[cell]))));
}

/// Those of libraryTrainingPaths(). A copy is evaluated as the network that it is: its table
/// of the MERL grid would take longer than all else.
std::vector<std::function<std::shared_ptr<const Brdf>()>> trainingMaterials() {
  std::vector<std::function<std::shared_ptr<const Brdf>()>> result;
  for (const MeasuredMaterial& measured : measuredMaterials())
    result.push_back([&measured] { return measuredMaterial(measured).brdf; });
  for (const NearMeasuredMaterial& copy : nearMeasuredMaterials())
    if (!isOriginalBundled(copy))
      result.push_back([&copy] { return std::make_shared<const NeuralBrdf>(copy.weights); });
  return result;
}

BundledBasis learn(const TaskControl& control) {
  const auto materials = trainingMaterials();
  BundledBasis basis;
  basis.largest.resize(bundledBasisGrid.size());
  const auto load = [&](std::size_t m) {
    control.throwIfStopped();
    const auto table = bakeTable(*materials[m](), bundledBasisGrid);
    raise(basis.largest, *table);
    return table;
  };
  basis.components =
      dictionary::learnPrincipalComponents(materials.size(), load, {.maxComponents = components}, control);
  return basis;
}

}  // namespace

std::shared_ptr<const BundledBasis> bundledBasis(const TaskControl& control) {
  static std::mutex mutex;
  static std::shared_ptr<const BundledBasis> basis;
  const std::scoped_lock lock(mutex);
  if (!basis) basis = std::make_shared<const BundledBasis>(learn(control));
  return basis;
}

}  // namespace gonio::materials
