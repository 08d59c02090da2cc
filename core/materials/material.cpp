// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/material.h"

#include <future>

#include "core/io/atomic_file.h"
#include "core/io/format_mismatch.h"
#include "core/io/merl_file.h"
#include "core/io/rgl_brdf.h"
#include "core/io/sha256.h"
#include "core/materials/bundled_library.h"
#include "core/materials/code_file.h"
#include "core/materials/pdv_file.h"
#include "core/support/naming_file.h"

namespace gonio::materials {

namespace {

/// One format: fills all of a material but its name, path and hash.
/// `read` throws FormatMismatch where the bytes are not of the format.
struct MaterialReader {
  std::string_view format;
  void (*read)(const io::ByteSource& source, const TaskControl& control, Material& material);
};

void readMerlMaterial(const io::ByteSource& source, const TaskControl& control, Material& material) {
  const io::MerlTable merl = io::readMerl(source, control);
  const HalfDifferenceGrid& grid = merl.table->grid();
  material.table = merl.table;
  material.brdf = merl.table;
  material.source.grid = {grid.thetaHCount, grid.thetaDCount, grid.phiDCount};
  if (merl.clampedCount > 0)
    material.source.notes.push_back(std::to_string(merl.clampedCount) + " small negative values were set to 0");
}

void readRglMaterial(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  io::RglFile rgl = io::readRgl(source);
  material.brdf = std::move(rgl.brdf);
  material.source.description = std::move(rgl.description);
  material.source.grid = std::move(rgl.grid);
  if (rgl.negativeCount > 0)
    material.source.notes.push_back(std::to_string(rgl.negativeCount) +
                                    " negative values; where they make a reflectance negative it is set to 0");
}

void readPdvMaterial(const io::ByteSource& source, const TaskControl&, Material& material) {
  if (!isPdv(source)) throw io::FormatMismatch("another start", "GONIOPDV");
  const factorization::PdvFactors factors = readPdv(source);
  material.brdf = factorization::makePdvBrdf(factors);
  material.source.grid = {int(factors.thetaNodes.size()), int(factors.deviationNodes.size()),
                          int(factors.phiNodes.size())};
  material.source.description = std::to_string(factors.terms()) + (factors.terms() == 1 ? " term of " : " terms of ") +
                                (factors.form == factorization::PdvForm::twoFactors ? "two" : "three") +
                                " factors, transform " +
                                std::string(dataTransformNames[std::size_t(factors.transform)]);
}

void readCodeMaterial(const io::ByteSource& source, const TaskControl&, Material& material) {
  if (!isCode(source)) throw io::FormatMismatch("another start", "GONIOCOD");
  setCode(readCode(source), material);
}

constexpr MaterialReader readers[] = {{"MERL", readMerlMaterial},
                                      {"RGL", readRglMaterial},
                                      {"PDV factors", readPdvMaterial},
                                      {"sparse code", readCodeMaterial}};

Material readFormat(const io::ByteSource& source, const TaskControl& control) {
  std::string refusals;
  for (const MaterialReader& reader : readers) {
    try {
      Material material;
      material.source.format = reader.format;
      reader.read(source, control, material);
      return material;
    } catch (const io::FormatMismatch& mismatch) {
      refusals += "\n  " + std::string(reader.format) + ": " + mismatch.what();
    }
  }
  throw Error("no reader takes this file:" + refusals);
}

}  // namespace

std::shared_ptr<const TabulatedBrdf> Material::tabulated(const TaskControl& control) const {
  return table ? table : bakeTable(*brdf, {}, control);
}

Material readMaterial(const io::ByteSource& source, const TaskControl& control) {
  auto hash = std::async(std::launch::async, [&source] { return io::sha256Hex(source); });
  Material material = readFormat(source, control);
  material.source.sha256 = hash.get();
  return material;
}

Material readMaterial(const std::filesystem::path& path, const TaskControl& control) {
  if (path.native().starts_with(libraryScheme)) return readLibraryMaterial(path.string());
  return namingFile(path, [&] {
    Material material = readMaterial(io::FileSource(path), control);
    material.name = path.stem().string();
    material.source.path = std::filesystem::absolute(path).lexically_normal();
    return material;
  });
}

void writeMerl(const TabulatedBrdf& table, const std::filesystem::path& path) {
  io::writeFileAtomically(path, io::encodeMerl(table));
}

void writeMerl(const Material& material, const std::filesystem::path& path, const TaskControl& control) {
  if (material.source.format != "MERL") return writeMerl(*material.tabulated(control), path);
  const std::vector<std::byte> bytes = namingFile(material.source.path, [&] {
    std::vector<std::byte> found = io::FileSource(material.source.path).readAll();
    if (io::sha256Hex(found) != material.source.sha256)
      throw Error("found other content than when it was read; read it again");
    return found;
  });
  control.throwIfStopped();
  io::writeFileAtomically(path, bytes);
}

}  // namespace gonio::materials
