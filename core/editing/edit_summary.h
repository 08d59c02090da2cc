// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/editing/edit.h"

namespace gonio::editing {

/// A short description of the effect of edits, such as "rougher, recoloured": at most two items of one to three words.
/// A name that the user gave to an edit replaces its description. Empty if no edit has an effect.
std::string editSummary(std::span<const Edit> edits);

/// The name of an edited material, such as "gold-paint, rougher"; the material's own name if no edit has an effect.
/// Valid as a file name: without '/', '\\' and ':'.
std::string editedName(const std::string& material, std::span<const Edit> edits);

}  // namespace gonio::editing
