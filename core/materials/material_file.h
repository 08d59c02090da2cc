// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <vector>

#include "core/materials/material.h"

namespace gonio::materials {

/// The bytes that a material was read from: of its file, or of a bundled measured one ("library:rgl/NAME").
/// @throws Error naming the file where it cannot be read or has changed since (its hash), and where the material is of
/// no file.
std::vector<std::byte> materialFile(const MaterialSource& source);

}  // namespace gonio::materials
