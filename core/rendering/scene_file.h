// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <optional>

#include "core/rendering/scene.h"

namespace gonio {

/// Reads a scene from JSON text; docs/scenes.md has the format. Objects of the material "each" stand once for each
/// material that is looked at, side by side along x.
/// @param materials how many materials are looked at, at least 1.
/// @param folder that the paths of meshes and environments start from; without one the text may name bundled ones
/// alone, and no file is opened.
/// @throws Error naming the member, what was found and what was expected.
Scene parseScene(const std::string& text, int materials, const std::optional<std::filesystem::path>& folder = {});

/// One of the project's own scenes by its name, a scene file (.json), or a mesh (.obj), which is scaled to the unit
/// sphere and stood on the ground in the studio.
/// @throws Error naming the file, or that lists the names.
Scene openScene(const std::string& nameOrPath, int materials = 1);

/// The names of the project's own scenes, in the order in which they are offered.
const std::vector<std::string>& bundledSceneNames();

}  // namespace gonio
