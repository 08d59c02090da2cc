// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/bundled_basis.h"

#include <algorithm>
#include <mutex>

#include "core/materials/bundled_library.h"

namespace gonio::materials {

namespace {

/// Of three a material. The others tell little of any material, and would cost memory.
constexpr int components = 64;

void raise(std::vector<float>& largest, const TabulatedBrdf& table) {
  for (std::size_t cell = 0; cell < largest.size(); ++cell)
    largest[cell] = std::max(largest[cell], float(maxChannel(Rgb(table.values()[cell]))));
}

BundledBasis learn(const TaskControl& control) {
  const std::vector<LibraryEntry>& library = bundledLibrary();
  BundledBasis basis;
  basis.largest.resize(bundledBasisGrid.size());
  const auto load = [&](std::size_t m) {
    control.throwIfStopped();
    const Material material = readLibraryMaterial(std::string(libraryScheme) + library[m].id);
    const auto table = bakeTable(*material.brdf, bundledBasisGrid);
    raise(basis.largest, *table);
    return table;
  };
  basis.components =
      dictionary::learnPrincipalComponents(library.size(), load, {.mostComponents = components}, control);
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
