// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/dictionary/dictionary.h"
#include "core/io/byte_source.h"

namespace gonio::materials {

struct NamedEnsemble;

/// The origin of a material.
struct MaterialSource {
  std::filesystem::path path;      ///< of the file, absolute; "library:sgd/chrome" for a bundled material
  std::string format;              ///< MaterialFormat::name of a file; "SGD fit", "blend", "gonio document"
  std::string sha256;              ///< of the file's bytes, or of a bundled material's parameters; lower-case hex
  std::string description;         ///< for display or from the file, e.g. "SGD fit of MERL chrome, Bagher et al. 2012"
  std::vector<int> grid;           ///< sizes of the stored data, e.g. 90 90 180
  std::vector<std::string> notes;  ///< what the reader changed, e.g. "12 negative values were set to 0"
};

/// A material as read: its origin, and its BRDF in its native form. Immutable once loaded.
struct Material {
  std::string name;
  MaterialSource source;
  std::shared_ptr<const Brdf> brdf;            ///< evaluates the file in its own parameterisation
  std::shared_ptr<const TabulatedBrdf> table;  ///< the same object if the file is a table, else null; for a table with
                                               ///< anisotropic edits the mean over the azimuths
  std::shared_ptr<const dictionary::SparseCode> code;  ///< for a sparse code over a bundled ensemble, else null
  std::shared_ptr<const NamedEnsemble> dictionary;     ///< of `code`

  /// `table`, or the BRDF sampled on the MERL grid; if it is not reciprocal, over the whole circle of phi_d (both
  /// orders of the directions) and with its negative values. About 1 s for an RGL file or factors. Methods for
  /// reciprocal materials use its meanOfOrders(). @throws Cancelled.
  std::shared_ptr<const TabulatedBrdf> tabulated(const TaskControl& control = {}) const;
};

/// Reads a file of any supported format, recognised by content, a bundled material ("library:SOURCE/NAME"), or a row of
/// a table of non-parametric factors ("FILE#ROW", npf_file.h).
/// @throws Error that names the file and the fault in its first line; if no format accepts the file, the following
/// lines state what each reader found. @throws Cancelled.
Material readMaterial(const std::filesystem::path& path, const TaskControl& control = {});
/// The same for bytes; the material has no name and no path, and errors name no file.
Material readMaterial(const io::ByteSource& source, const TaskControl& control = {});

/// The bytes from which a material was read: its file, or that of a bundled measured material ("library:rgl/NAME").
/// @throws Error that names the file, if it cannot be read or its hash has changed, or if the material has no file.
std::vector<std::byte> materialFile(const MaterialSource& source);

/// Where the data of a bundled material come from.
enum class LibraryOrigin { measured, nearMeasured, publishedFit };
/// The name for display: "measured", "near-measured copy", "published fit".
std::string_view libraryOriginName(LibraryOrigin origin);

struct LibraryEntry {
  std::string id;           ///< source (core/materials/bundled_library.h) and name, e.g. "sgd/chrome"
  std::string name;         ///< for display, e.g. "chrome"
  std::string description;  ///< for display, e.g. "SGD fit of MERL chrome, Bagher et al. 2012"
  LibraryOrigin origin = LibraryOrigin::measured;
  std::string kind;  ///< "metal", "paint", ...
};
/// The bundled materials: measured ones, then near-measured copies, then published fits.
const std::vector<LibraryEntry>& bundledLibrary();

}  // namespace gonio::materials
