// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/editing/edit.h"
#include "core/export/export_source.h"
#include "core/materials/material.h"

namespace gonio::exports {

/// The input of exports, with the origin as text: source, hash, edits, version of Gonio. Names may contain anything:
/// both texts are plainText(). @param base the material
/// without edits. @param shown the BRDF with edits; base.brdf if there are none. @throws Error if `base` is an RGL file
/// that cannot be read again.
ExportSource exportSource(const std::string& name, const materials::Material& base, std::shared_ptr<const Brdf> shown,
                          const editing::EditList& edits);

/// The default name of an export: editing::editedName() as plainText(), without commas and with '_' for spaces, since
/// other programs treat both as separators. Examples: "chrome", "chrome_rougher".
std::string proposedName(const std::string& material, const editing::EditList& edits);

}  // namespace gonio::exports
