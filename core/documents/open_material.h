// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/documents/edited_material.h"

namespace gonio::editing {

/// Whether it is a .gonio document, by its content (JSON). A file that cannot be read is none.
bool isDocument(const std::string& path);

/// Anything that is a material: a file, a .gonio document, or "library:SOURCE/NAME".
/// @throws Error naming the file; of a document also when its source has changed since; Cancelled.
EditedMaterial openWithEdits(const std::string& path, const TaskControl& control = {});
/// The same as it is shown.
materials::Material openMaterial(const std::string& path, const TaskControl& control = {});

}  // namespace gonio::editing
