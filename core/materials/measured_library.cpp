// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/measured_library.h"

#include <cstdio>
#include <sstream>

#include "core/io/sha256.h"
#include "core/materials/code_file.h"

extern "C" {
// One behind the other, in the order of the list, with the borders between them (bundled_files.S).
extern const std::byte* const gonioMeasuredCodes[];
}

namespace gonio::materials {

std::string MeasuredMaterial::description() const {
  char text[128];
  std::snprintf(text, sizeof text, "RGL, measured; code of %d coefficients a channel, rendered SNR %.1f dB",
                coefficients, renderedSnr);
  return text;
}

std::string MeasuredMaterial::sha256() const { return io::sha256Hex(io::MemorySource(code)); }

const std::vector<MeasuredMaterial>& measuredMaterials() {
  static const std::vector<MeasuredMaterial> materials = [] {
    std::vector<MeasuredMaterial> result;
    std::istringstream lines{std::string(measuredFigures())};
    std::string line;
    std::getline(lines, line);
    for (std::size_t i = 0; std::getline(lines, line); ++i) {
      MeasuredMaterial& material = result.emplace_back();
      std::istringstream cells(line);
      char comma;
      std::getline(cells, material.name, ',');
      cells >> material.coefficients >> comma >> material.renderedSnr;
      material.code = {gonioMeasuredCodes[i], gonioMeasuredCodes[i + 1]};
    }
    return result;
  }();
  return materials;
}

Material measuredMaterial(const MeasuredMaterial& measured) {
  const io::MemorySource source(measured.code);
  Material material;
  material.name = measured.name;
  material.source.format = "sparse code";
  setCode(readCode(source), material);
  material.source.sha256 = measured.sha256();
  material.source.description = measured.description();
  return material;
}

}  // namespace gonio::materials
