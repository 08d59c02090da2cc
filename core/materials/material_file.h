// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <vector>

#include "core/materials/material.h"

namespace gonio::materials {

/// The bytes from which a material was read: its file, or that of a bundled measured material ("library:rgl/NAME").
/// @throws Error that names the file, if it cannot be read or its hash has changed, or if the material has no file.
std::vector<std::byte> materialFile(const MaterialSource& source);

}  // namespace gonio::materials
