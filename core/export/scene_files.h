// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/export/export_files.h"
#include "core/math/image.h"
#include "core/rendering/scene.h"

namespace gonio::exports {

/// Names of the files of a scene, without folders: all are in the same folder.
struct SceneFileNames {
  std::string name;                 ///< of the export
  std::string material;             ///< file of the material in all slots
  std::string environment;          ///< empty if the scene has none
  std::vector<std::string> meshes;  ///< one per object of the scene; empty if it is not a mesh
};

/// The scene format of a renderer: a file that describes the scene, an image of the environment, and a PLY file per
/// mesh. Objects, lights and the camera are those of Scene. Not supported: the blurred background, and the grain
/// direction of anisotropic materials on meshes, which each renderer chooses itself.
struct SceneFormat {
  std::string_view textSuffix, environmentSuffix;
  std::string_view materialSuffix;           ///< suffix of the target's file that the scene uses
  std::string_view excludedCharacters = {};  ///< those that the names of its files cannot contain
  std::string (*text)(const Scene& scene, const SceneFileNames& files);
  Image (*environment)(const Scene& scene);  ///< precondition: the scene has an environment
};

/// The suffixes of the files of a scene; those of meshes are "_mesh1.ply" and so on.
std::vector<std::string> sceneSuffixes(const SceneFormat& format, const Scene& scene);
/// Checks that a scene can name its files: the name is plainText() without characters that the format excludes.
/// @param name of the export, without folders. @throws Error that states the name and the reason.
void checkSceneName(const SceneFormat& format, const std::string& name);
/// The files of a scene. @param name of the export, without folders. @throws Error as checkSceneName().
std::vector<ExportPart> sceneParts(const SceneFormat& format, const Scene& scene, const std::string& name);

/// Side of the square pictures of exported scenes, and samples per pixel.
inline constexpr int scenePixels = 512, scenePictureSamples = 256;

/// The components separated by spaces, e.g. "1 2 3".
std::string spaced(const Direction& v);

}  // namespace gonio::exports
