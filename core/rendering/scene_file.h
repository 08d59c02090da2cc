// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "core/rendering/scene.h"

namespace gonio::rendering {

struct BundledScene {
  std::string_view name, json;
};
/// resources/scenes/*.json, in the order of display.
std::span<const BundledScene> bundledScenes();

/// Reads a scene from JSON text; docs/scenes.md has the format. An object with the material "each" is repeated for
/// every displayed material, side by side along x.
/// @param materials number of displayed materials, at least 1.
/// @param folder base of the paths of meshes and environments; empty: only bundled ones are permitted, and no file is
/// opened.
/// @throws Error that names the member, what was found and what was expected.
Scene parseScene(const std::string& text, int materials, const std::optional<std::filesystem::path>& folder = {});

/// Opens a bundled scene by its name (comparisonSceneName is another name of bundledComparisonScene), a scene file
/// (.json), or a mesh, which is scaled to the unit sphere and placed on the ground in the studio.
/// @param pose of a mesh: z up turns it by a quarter turn about x, so that its z axis points up and its y axis away
/// from the viewer. Scene files state the axis and the turn of each mesh.
/// @throws Error that names the file or lists the names; Error if the up axis is not y and the scene is not a mesh.
Scene openScene(const std::string& nameOrPath, int materials = 1, const MeshPose& pose = {});

/// "y" or "z".
std::string_view upAxisName(UpAxis up);
/// @throws Error that states the name, if it is neither.
UpAxis upAxisOf(std::string_view name);

/// The names of the bundled scenes, in the order of display.
const std::vector<std::string>& bundledSceneNames();

}  // namespace gonio::rendering
