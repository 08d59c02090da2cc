// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/material_file.h"

#include <algorithm>

#include "core/io/sha256.h"
#include "core/materials/bundled_library.h"
#include "core/materials/library_list.h"
#include "core/materials/measured_library.h"
#include "core/support/file_in_errors.h"

namespace gonio::materials {

namespace {

std::vector<std::byte> bundledFile(const MaterialSource& source) {
  const std::string prefix = std::string(libraryScheme).append(rglSource).append("/"), path = source.path.string();
  const auto found = std::ranges::find_if(
      measuredMaterials(), [&](const MeasuredMaterial& measured) { return prefix + measured.name == path; });
  if (found == measuredMaterials().end()) throw Error(path + ": this bundled material is computed and has no file");
  return {found->file.begin(), found->file.end()};
}

}  // namespace

std::vector<std::byte> materialFile(const MaterialSource& source) {
  if (source.path.native().starts_with(libraryScheme)) return bundledFile(source);
  return withFileInErrors(source.path, [&] {
    std::vector<std::byte> found = io::FileSource(source.path).readAll();
    if (io::sha256Hex(found) != source.sha256) throw Error("the file has changed since it was read; open it again");
    return found;
  });
}

}  // namespace gonio::materials
