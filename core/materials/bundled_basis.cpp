// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/bundled_basis.h"

#include <mutex>

#include "core/materials/bundled_library.h"

namespace gonio::materials {

namespace {

/// Of three a material. The others tell little of any material, and would cost memory.
constexpr int components = 64;

dictionary::PrincipalComponents learn(const TaskControl& control) {
  const std::vector<LibraryEntry>& library = bundledLibrary();
  const auto load = [&](std::size_t m) {
    control.throwIfStopped();
    const Material material = readLibraryMaterial(std::string(libraryScheme) + library[m].id);
    return bakeTable(*material.brdf, bundledBasisGrid);
  };
  return dictionary::learnPrincipalComponents(library.size(), load, {.mostComponents = components}, control);
}

}  // namespace

std::shared_ptr<const dictionary::PrincipalComponents> bundledBasis(const TaskControl& control) {
  static std::mutex mutex;
  static std::shared_ptr<const dictionary::PrincipalComponents> basis;
  const std::scoped_lock lock(mutex);
  if (!basis) basis = std::make_shared<const dictionary::PrincipalComponents>(learn(control));
  return basis;
}

}  // namespace gonio::materials
