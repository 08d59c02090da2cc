// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/bundled_library.h"

#include <optional>

#include "core/materials/library_list.h"
#include "core/materials/measured_library.h"
#include "core/materials/near_measured_library.h"
#include "core/materials/sgd_library.h"
#include "core/support/error.h"

namespace gonio::materials {

namespace {

std::string idOf(std::string_view source, std::string_view name) {
  return std::string(source).append("/").append(name);
}
std::string idOf(const MeasuredMaterial& measured) { return idOf(rglSource, measured.name); }
std::string idOf(const NearMeasuredMaterial& copy) { return idOf(copy.source, copy.name); }
std::string idOf(const SgdFit& fit) { return idOf(sgdSource, fit.name); }

LibraryOrigin originOf(const MeasuredMaterial&) { return LibraryOrigin::measured; }
LibraryOrigin originOf(const NearMeasuredMaterial&) { return LibraryOrigin::nearMeasured; }
LibraryOrigin originOf(const SgdFit&) { return LibraryOrigin::publishedFit; }

/// Calls `visit` with each list of bundled materials.
template <class Visit>
void visitLists(const Visit& visit) {
  visit(measuredMaterials());
  visit(nearMeasuredMaterials());
  visit(sgdFits());
}

/// Calls `visit` with the bundled material of a path, if there is one.
template <class Visit>
void visitNamed(const std::string& path, const Visit& visit) {
  if (!path.starts_with(libraryScheme)) return;
  const std::string_view id = std::string_view(path).substr(libraryScheme.size());
  visitLists([&](const auto& list) {
    for (const auto& entry : list)
      if (idOf(entry) == id) visit(entry);
  });
}

Material materialOf(const MeasuredMaterial& measured, const TaskControl&) { return measuredMaterial(measured); }
Material materialOf(const NearMeasuredMaterial& copy, const TaskControl& control) {
  return nearMeasuredMaterial(copy, control);
}
Material materialOf(const SgdFit& fit, const TaskControl&) { return sgdMaterial(fit); }

}  // namespace

std::string_view libraryOriginName(LibraryOrigin origin) {
  constexpr std::string_view names[] = {"measured", "near-measured copy", "published fit"};
  return names[std::size_t(origin)];
}

const std::vector<LibraryEntry>& bundledLibrary() {
  static const std::vector<LibraryEntry> entries = [] {
    std::vector<LibraryEntry> result;
    visitLists([&](const auto& list) {
      for (const auto& entry : list) {
        const std::string id = idOf(entry);
        result.push_back({id, entry.name, entry.description(), originOf(entry),
                          libraryKind(std::string_view(id).substr(0, id.find('/')), entry.name)});
      }
    });
    return result;
  }();
  return entries;
}

std::string librarySha256(const std::string& path) {
  std::string found;
  visitNamed(path, [&](const auto& entry) { found = entry.sha256(); });
  return found;
}

std::vector<std::string> libraryTrainingPaths() {
  std::vector<std::string> paths;
  const auto add = [&paths](const auto& entry) { paths.push_back(std::string(libraryScheme) + idOf(entry)); };
  for (const MeasuredMaterial& measured : measuredMaterials()) add(measured);
  for (const NearMeasuredMaterial& copy : nearMeasuredMaterials())
    if (!isOriginalBundled(copy)) add(copy);
  return paths;
}

Material readLibraryMaterial(const std::string& path, const TaskControl& control) {
  std::optional<Material> found;
  visitNamed(path, [&](const auto& entry) { found = materialOf(entry, control); });
  if (!found)
    throw Error(path + ": no bundled material has this name; there are " + std::to_string(bundledLibrary().size()) +
                ", for example " + std::string(libraryScheme) + bundledLibrary().back().id);
  found->source.path = path;
  return std::move(*found);
}

}  // namespace gonio::materials
