// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/bundled_library.h"

#include "core/materials/measured_library.h"
#include "core/materials/sgd_library.h"
#include "core/support/error.h"

namespace gonio::materials {

namespace {

constexpr std::string_view measuredPrefix = "rgl/", fitPrefix = "sgd/";

/// The entry of a path; null where there is none.
template <class Entry>
const Entry* findNamed(const std::vector<Entry>& entries, std::string_view prefix, const std::string& path) {
  for (const Entry& entry : entries)
    if (path == std::string(libraryScheme).append(prefix).append(entry.name)) return &entry;
  return nullptr;
}

}  // namespace

const std::vector<LibraryEntry>& bundledLibrary() {
  static const std::vector<LibraryEntry> entries = [] {
    std::vector<LibraryEntry> result;
    for (const MeasuredMaterial& measured : measuredMaterials())
      result.push_back({std::string(measuredPrefix) + measured.name, measured.name, measured.description()});
    for (const SgdFit& fit : sgdFits())
      result.push_back({std::string(fitPrefix) + fit.name, fit.name, fit.description()});
    return result;
  }();
  return entries;
}

std::string librarySha256(const std::string& path) {
  if (const MeasuredMaterial* measured = findNamed(measuredMaterials(), measuredPrefix, path))
    return measured->sha256();
  if (const SgdFit* fit = findNamed(sgdFits(), fitPrefix, path)) return fit->sha256();
  return {};
}

Material readLibraryMaterial(const std::string& path) {
  const auto named = [&path](Material material) {
    material.source.path = path;
    return material;
  };
  if (const MeasuredMaterial* measured = findNamed(measuredMaterials(), measuredPrefix, path))
    return named(measuredMaterial(*measured));
  if (const SgdFit* fit = findNamed(sgdFits(), fitPrefix, path)) return named(sgdMaterial(*fit));
  throw Error(path + ": found no such bundled material, expected one of " + std::to_string(bundledLibrary().size()) +
              " such as " + std::string(libraryScheme) + bundledLibrary().back().id);
}

}  // namespace gonio::materials
