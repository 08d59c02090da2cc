// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/measured_library.h"

#include "core/io/sha256.h"
#include "core/io/tensor_file.h"
#include "core/materials/library_list.h"

extern "C" {
// One behind the other, in the order of the list, with the borders between them (bundled_files.S).
extern const std::byte* const gonioMeasuredFiles[];
}

namespace gonio::materials {

std::string MeasuredMaterial::description() const {
  return "measurement from the RGL database: " + io::TensorFile(io::MemorySource(file)).text("description");
}

std::string MeasuredMaterial::sha256() const { return io::sha256Hex(io::MemorySource(file)); }

const std::vector<MeasuredMaterial>& measuredMaterials() {
  static const std::vector<MeasuredMaterial> materials = [] {
    std::vector<MeasuredMaterial> result;
    for (const LibraryRow& row : libraryRows()) {
      if (row.source != rglSource) continue;
      const std::size_t i = result.size();
      result.push_back({row.name, {gonioMeasuredFiles[i], gonioMeasuredFiles[i + 1]}});
    }
    return result;
  }();
  return materials;
}

Material measuredMaterial(const MeasuredMaterial& measured) {
  Material material = readMaterial(io::MemorySource(measured.file));
  material.name = measured.name;
  material.source.description = measured.description();
  return material;
}

}  // namespace gonio::materials
