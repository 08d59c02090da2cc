// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/dictionary/sparse_code.h"
#include "core/io/byte_source.h"

namespace gonio::materials {

/// Where a material comes from.
struct MaterialSource {
  std::filesystem::path path;      ///< of the file, absolute; "library:sgd/chrome" for a bundled material
  std::string format;              ///< MaterialFormat::name of a file; "SGD fit", "blend", "gonio document"
  std::string sha256;              ///< of the file's bytes, or of a bundled material's parameters; lower-case hex
  std::string description;         ///< from the file or for people: "SGD fit of MERL chrome, Bagher et al. 2012"
  std::vector<int> grid;           ///< sizes of the stored data, e.g. 90 90 180
  std::vector<std::string> notes;  ///< what the reader changed: "12 negative values were set to 0"
};

/// A material as it was read: the source and its BRDF in the file's own form. Immutable once loaded.
struct Material {
  std::string name;
  MaterialSource source;
  std::shared_ptr<const Brdf> brdf;                    ///< evaluates the file in its own parameterisation
  std::shared_ptr<const TabulatedBrdf> table;          ///< the same object when the file is a table, else null;
                                                       ///< of an anisotropic replayed edit its mean over the azimuths
  std::shared_ptr<const dictionary::SparseCode> code;  ///< of a sparse code over bundledDictionary(), else null

  /// The table for editing: `table`, or the BRDF sampled onto the MERL grid (about 1 s for an RGL file or
  /// factors).
  std::shared_ptr<const TabulatedBrdf> tabulated(const TaskControl& control = {}) const;
};

/// Reads any supported file, found by its content, or a bundled material by "library:sgd/NAME" or "library:rgl/NAME".
/// @throws Error naming the file and in its first line what is wrong with it; of one that could not be read the lines
/// after it state what each format found.
/// @throws Cancelled.
Material readMaterial(const std::filesystem::path& path, const TaskControl& control = {});
/// The same of bytes; the material has no name and no path, an error names no file.
Material readMaterial(const io::ByteSource& source, const TaskControl& control = {});

/// Writes a table or a material, atomically, in the format that the suffix asks for (writableFormat()). A file of this
/// format that was only read is copied byte for byte (its hash is verified first); all else is tabulated.
/// @throws Error naming the file.
void writeMaterial(const TabulatedBrdf& table, const std::filesystem::path& path);
void writeMaterial(const Material& material, const std::filesystem::path& path, const TaskControl& control = {});

/// What a bundled material is.
enum class LibraryOrigin { measured, nearMeasured, publishedFit };
/// "measured", "near-measured copy", "published fit".
std::string_view libraryOriginName(LibraryOrigin origin);

struct LibraryEntry {
  std::string id;           ///< "sgd/chrome": the source (core/materials/library_list.h) and the name
  std::string name;         ///< "chrome"
  std::string description;  ///< for people: "SGD fit of MERL chrome, Bagher et al. 2012"
  LibraryOrigin origin = LibraryOrigin::measured;
  std::string kind;  ///< "metal", "paint", ...
};
/// The bundled materials: measured ones, then near-measured copies, then published fits.
const std::vector<LibraryEntry>& bundledLibrary();

}  // namespace gonio::materials
