// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/editing/edit.h"
#include "core/export/export_source.h"
#include "core/materials/material.h"

namespace gonio::exports {

/// A material as exports take it, with its origin as a sentence: source, hash, edits, version of Gonio.
/// @param base without edits. @param shown with them: the base's own BRDF where there are none.
/// @throws Error where `base` is an RGL file that cannot be read again.
ExportSource exportSource(std::string name, const materials::Material& base, std::shared_ptr<const Brdf> shown,
                          const editing::EditList& edits);

/// What an export is called before anyone gives it a name: editing::editedName() without commas and spaces, which other
/// programs take for separators: "chrome", "chrome_rougher".
std::string proposedName(const std::string& material, const editing::EditList& edits);

}  // namespace gonio::exports
