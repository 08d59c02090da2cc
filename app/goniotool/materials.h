// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/materials/material_formats.h"

namespace gonio::tool {

inline constexpr const char* materialHelp = "A material: a file, a .gonio document, or library:SOURCE/NAME";

/// Whether it is a .gonio document, by its content (JSON). A file that cannot be read is none.
bool isDocument(const std::string& argument);

/// A material argument. A document is replayed: the material is its edited table.
/// @throws Error naming the file; of a document also when its source has changed since.
materials::Material openMaterial(const std::string& argument, const TaskControl& control = {});

/// For help texts: ".pdv".
inline std::string suffixOf(materials::FormatId id) { return std::string(materials::formatOf(id).suffix()); }
/// The help of an option that names a material to write: "The material (.binary)".
std::string outputHelp(const std::string& what);

}  // namespace gonio::tool
