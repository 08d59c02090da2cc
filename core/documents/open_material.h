// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/materials/edited_material.h"

namespace gonio::documents {

/// Whether a file is a .gonio document: its first character other than white space is '{', and it has their suffix or
/// the member "format" of documents. False if it cannot be read, and for JSON of other programs.
bool isDocument(const std::string& path);

/// Reads a .gonio file and applies its edits (materials::withEdits()). The material is named after the file if it has
/// edits or is a blend; its source.sha256 is that of the source. @throws Error that names the file, also if the source
/// has changed since the edits were made; Cancelled.
materials::EditedMaterial editedMaterial(const std::filesystem::path& document, const TaskControl& control = {});

/// Opens any material: a file, a .gonio document, or "library:SOURCE/NAME". @throws Error that names the file; for a
/// document also if its source has changed since; Cancelled.
materials::EditedMaterial openWithEdits(const std::string& path, const TaskControl& control = {});
/// The material with its edits applied.
materials::Material openMaterial(const std::string& path, const TaskControl& control = {});

/// The files of a material: the file itself and, for a document, the files that it edits, including those of its
/// blends. Empty if there is no such file, as for bundled materials.
std::vector<std::filesystem::path> filesOf(const std::string& path);

}  // namespace gonio::documents
