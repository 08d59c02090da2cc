// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/materials/material.h"

namespace gonio::editing {

/// The material that a .gonio file holds, its edits applied: a table where the source is one, else the source's own
/// form under its edits. Named after the file. `source.sha256` is that of the source.
/// @throws Error naming the file; where the source has changed since; Cancelled.
materials::Material editedMaterial(const std::filesystem::path& document, const TaskControl& control = {});

}  // namespace gonio::editing
