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

/// The files that a scene is made of, by their names without folders: they lie in one.
struct SceneFileNames {
  std::string name;                 ///< of the export
  std::string material;             ///< the file with the material that fills all slots
  std::string environment;          ///< empty: the scene has none
  std::vector<std::string> meshes;  ///< one for each object of the scene, empty where it is no mesh
};

/// How a renderer reads a scene: a file that describes it, a picture of the environment, and a PLY file for each mesh.
/// Objects, lights and the camera are those of Scene. Left out: a background out of focus, and the grain of anisotropic
/// materials on meshes, which each renderer chooses for itself.
struct SceneFormat {
  std::string_view textSuffix, environmentSuffix;
  std::string_view materialSuffix;  ///< of the target's files, the one that the scene names
  std::string (*text)(const Scene& scene, const SceneFileNames& files);
  Image (*environment)(const Scene& scene);  ///< contract: the scene has one
};

/// Of the files of a scene: NAME_mesh1.ply and so on for its meshes.
std::vector<std::string> sceneSuffixes(const SceneFormat& format, const Scene& scene);
/// The files. @param name of the export, without folders.
std::vector<ExportPart> sceneParts(const SceneFormat& format, const Scene& scene, const std::string& name);

/// Pictures of exported scenes are squares of this side, with so many samples per pixel.
inline constexpr int scenePixels = 512, scenePictureSamples = 256;

/// For attributes of XML and strings of pbrt: what would end them is not in names of files that renderers open.
std::string quotable(std::string name);
/// "1 2 3"
std::string spaced(const Direction& v);

}  // namespace gonio::exports
