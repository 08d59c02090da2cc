// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/material.h"

#include <cassert>
#include <future>

#include "core/fitting/fit_data.h"
#include "core/io/byte_source.h"
#include "core/io/sha256.h"
#include "core/materials/bundled_library.h"
#include "core/materials/material_formats.h"
#include "core/materials/npf_file.h"
#include "core/sampling/directional_albedo.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::materials {

namespace {

/// A note if the albedo exceeds 1 by more than 5 % for a viewer at 0 to 60 degrees, as for values in another unit, with
/// the cosine or from a wrong column: then it does so without narrow peaks. At grazing angles measurements are too
/// noisy for it. About 10 ms.
void noteAlbedo(Material& material) {
  constexpr double limit = 1.05;
  // The first estimate is rough, and confirmed.
  constexpr std::uint32_t few = 1 << 10, many = 1 << 14;
  const auto albedo = [&](int angle, std::uint32_t samples) {
    return maxChannel(DirectionalAlbedo(*material.brdf, samples, DirectionalAlbedo::Peaks::ignored)(radians(angle)));
  };
  for (const int angle : {0, 20, 40, 60}) {
    if (!(albedo(angle, few) > limit)) continue;
    const double confirmed = albedo(angle, many);
    if (!(confirmed > limit)) continue;
    material.source.notes.push_back("warning: the albedo at " + std::to_string(angle) + " degrees is " +
                                    numberText(float(confirmed)) +
                                    ", more than 1: check the columns and units of the file (BRDF in 1/sr, without the "
                                    "cosine)");
    return;
  }
}

/// A note if a table has so few valid cells that nearly all of what it shows is extrapolated.
void noteFewCells(Material& material) {
  if (!material.table || material.table->validCount() >= fitting::fewCells) return;
  const std::size_t valid = material.table->validCount();
  material.source.notes.push_back("warning: only " + std::to_string(valid) + " of " +
                                  std::to_string(material.table->values().size()) + " cells " +
                                  (valid == 1 ? "is" : "are") + " valid");
}

Material readFormat(const io::ByteSource& source, const TaskControl& control) {
  const MaterialFormat& format = sniffFormat(source);
  Material material;
  material.source.format = format.name;
  try {
    format.read(source, control, material);
  } catch (const io::FormatMismatch& mismatch) {
    throw Error(std::string(format.name) + ": " + mismatch.what());
  }
  assert(format.holds.anisotropic || material.brdf->isIsotropic());
  noteFewCells(material);
  noteAlbedo(material);
  return material;
}

/// @throws Error that names the format, if it is one that is not read.
Material readKnownFormat(const std::filesystem::path& path, const TaskControl& control) {
  try {
    return readMaterial(io::FileSource(path, control.stop), control);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    const std::string unread = unreadFormat(path);
    if (unread.empty()) throw;
    throw Error("found " + unread + ", which Gonio does not read");
  }
}

}  // namespace

std::shared_ptr<const TabulatedBrdf> Material::tabulated(const TaskControl& control) const {
  if (table) return table;
  constexpr int azimuths = 16;
  const HalfDifferenceGrid grid;
  if (brdf->isReciprocal()) return bakeTable(*brdf, grid, control, azimuths);
  return bakeTable(*brdf, grid.wholeCircle(), control, azimuths, NegativeValues::stay);
}

Material readMaterial(const io::ByteSource& source, const TaskControl& control) {
  // Large files are hashed while they are read; small ones afterwards, because starting a thread would take longer.
  const auto launch = source.size() > (std::size_t(1) << 18) ? std::launch::async : std::launch::deferred;
  // Its destructor waits for the hash, which nobody needs once reading has failed.
  std::stop_source failed;
  auto hash = std::async(launch, [&source, stop = failed.get_token()] { return io::sha256Hex(source, stop); });
  try {
    Material material = readFormat(source, control);
    material.source.sha256 = hash.get();
    return material;
  } catch (...) {
    failed.request_stop();
    throw;
  }
}

Material readMaterial(const std::filesystem::path& path, const TaskControl& control) {
  if (path.native().starts_with(libraryScheme)) return readLibraryMaterial(path.string(), control);
  if (isNpfRow(path)) return readNpfRow(path);
  return withFileInErrors(path, [&] {
    Material material = readKnownFormat(path, control);
    material.name = path.stem().string();
    material.source.path = std::filesystem::absolute(path).lexically_normal();
    return material;
  });
}

std::vector<std::byte> materialFile(const MaterialSource& source) {
  if (source.path.native().starts_with(libraryScheme)) return bundledFile(source.path.string());
  return withFileInErrors(source.path, [&] {
    std::vector<std::byte> found = io::FileSource(source.path).readAll();
    if (io::sha256Hex(found) != source.sha256) throw Error("the file has changed since it was read; open it again");
    return found;
  });
}

}  // namespace gonio::materials
