// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/documents/open_material.h"
#include "core/materials/material_formats.h"

namespace gonio::tool {

inline constexpr const char* materialHelp = "A material: a file, a .gonio document, or library:SOURCE/NAME";

using editing::isDocument;
using editing::openMaterial;

/// For help texts: ".pdv".
inline std::string suffixOf(materials::FormatId id) { return std::string(materials::formatOf(id).suffix()); }
/// The help of an option that names a material to write: "The material (.binary)".
std::string outputHelp(const std::string& what);

}  // namespace gonio::tool
