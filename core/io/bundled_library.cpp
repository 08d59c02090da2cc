// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/bundled_library.h"

#include "core/io/measured_library.h"
#include "core/io/sgd_library.h"
#include "core/support/error.h"

namespace gonio::io {

namespace {

constexpr std::string_view measuredPrefix = "rgl/", fitPrefix = "sgd/";

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

Material readLibraryMaterial(const std::string& path) {
  const std::string_view id = std::string_view(path).substr(libraryScheme.size());
  const auto isNamed = [id](std::string_view prefix, const std::string& name) {
    return id.starts_with(prefix) && id.substr(prefix.size()) == name;
  };
  const auto named = [&path](Material material) {
    material.source.path = path;
    return material;
  };
  for (const MeasuredMaterial& measured : measuredMaterials())
    if (isNamed(measuredPrefix, measured.name)) return named(measuredMaterial(measured));
  for (const SgdFit& fit : sgdFits())
    if (isNamed(fitPrefix, fit.name)) return named(sgdMaterial(fit));
  throw Error(path + ": found no such bundled material, expected one of " + std::to_string(bundledLibrary().size()) +
              " such as " + std::string(libraryScheme) + bundledLibrary().back().id);
}

}  // namespace gonio::io
