// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/materials/material.h"

namespace gonio::tool {

inline constexpr const char* materialHelp = "A material: a file, a .gonio document, or library:sgd/NAME";

/// Whether it is a .gonio document, by its content (JSON). A file that cannot be read is none.
bool isDocument(const std::string& argument);

/// A material argument. A document is replayed: the material is its edited table.
/// @throws Error naming the file; of a document also when its source has changed since.
materials::Material openMaterial(const std::string& argument, const TaskControl& control = {});

/// Writes a table or a material by the suffix of `out`. An unchanged MERL material is copied byte for byte.
/// @throws Error when the suffix is of no format that is written.
void writeMaterial(const materials::Material& material, const std::string& out, const TaskControl& control = {});
void writeMaterial(const TabulatedBrdf& table, const std::string& out);
/// Of the same check alone, so that no work is done for nothing.
void checkOutput(const std::string& out);

}  // namespace gonio::tool
