// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/editing/edit.h"

namespace gonio::editing {

/// What edits make of a material, in one to three words each of at most two: "rougher, recoloured". An edit that the
/// user named has that name. Empty where nothing is changed.
std::string editWords(std::span<const Edit> edits);

/// The name of an edited material, for a file too (without '/', '\\' and ':'): "gold-paint, rougher"; the material's
/// own where nothing is changed.
std::string editedName(const std::string& material, std::span<const Edit> edits);

}  // namespace gonio::editing
