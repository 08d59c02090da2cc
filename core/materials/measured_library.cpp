// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/measured_library.h"

#include <cstdio>

#include "core/io/csv_text.h"
#include "core/io/sha256.h"
#include "core/materials/code_file.h"
#include "core/materials/material_formats.h"

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
    const io::CsvText csv = io::readCsvText(measuredFigures());
    const std::size_t name = csv.neededColumn("name"), coefficients = csv.neededColumn("coefficients"),
                      snr = csv.neededColumn("rendered_snr");
    std::vector<MeasuredMaterial> result;
    for (std::size_t i = 0; i < csv.rows.size(); ++i) {
      const io::CsvText::Row& row = csv.rows[i];
      result.push_back({.name = row.fields[name],
                        .coefficients = csv.integer(row, coefficients),
                        .renderedSnr = csv.number(row, snr),
                        .code = {gonioMeasuredCodes[i], gonioMeasuredCodes[i + 1]}});
    }
    return result;
  }();
  return materials;
}

Material measuredMaterial(const MeasuredMaterial& measured) {
  const io::MemorySource source(measured.code);
  Material material;
  material.name = measured.name;
  material.source.format = formatOf(FormatId::code).name;
  setCode(readCode(source), material);
  material.source.sha256 = measured.sha256();
  material.source.description = measured.description();
  return material;
}

}  // namespace gonio::materials
