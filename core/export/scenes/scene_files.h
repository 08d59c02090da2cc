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
  std::string_view environmentLayout = {};   ///< io::layoutAttribute; empty: latitude-longitude
  std::string_view materialSuffix;           ///< suffix of the target's file that the scene uses
  std::string_view excludedCharacters = {};  ///< those that the names of its files cannot contain
  std::string (*text)(const rendering::Scene& scene, const SceneFileNames& files);
  Image (*environment)(const rendering::Scene& scene);  ///< precondition: the scene has an environment
};

/// The suffixes of the files of a scene; those of meshes are "_mesh1.ply" and so on.
std::vector<std::string> sceneSuffixes(const SceneFormat& format, const rendering::Scene& scene);
/// Checks that a scene can name its files: the name is plainText() without characters that the format excludes.
/// @param name of the export, without folders. @throws Error that states the name and the reason.
void checkSceneName(const SceneFormat& format, const std::string& name);
/// The files of a scene. @param name of the export, without folders. @throws Error as checkSceneName().
std::vector<ExportPart> sceneParts(const SceneFormat& format, const rendering::Scene& scene, const std::string& name);

/// Side of the square pictures of exported scenes, and samples per pixel.
inline constexpr int scenePixels = 512, scenePictureSamples = 256;

/// NAME_scene.xml for Mitsuba 3 with NAME_rgb.bsdf, and NAME_environment.exr, a latitude-longitude map.
const SceneFormat& mitsubaSceneFormat();

/// NAME_scene.pbrt for pbrt-v4 with NAME_spec.bsdf, and NAME_environment_octahedral.exr (octahedralEnvironment()). In
/// pbrt the environment is always visible, and Lambertian rectangles also reflect from their backs.
const SceneFormat& pbrtSceneFormat();

/// The environment as pbrt-v4 reads it: a square with `side` pixels per side in the equal-area octahedral mapping of
/// Clarberg 2008, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD", about the world's z axis, rotated by
/// `rotation` (EnvironmentRotation). Bilinear: details smaller than a pixel are lost.
Image octahedralEnvironment(const rendering::EnvironmentMap& environment, double rotation, int side);

/// NAME_scene.py, a script for Blender 3.4 and later that creates a scene for Cycles with the material of
/// NAME_blender.py (blenderSceneFormat()) or NAME_principled.py (principledSceneFormat()), and NAME_environment.exr, a
/// latitude-longitude map. In Blender's axes z is up and -y points to the viewer. Rectangles also reflect from their
/// backs.
const SceneFormat& blenderSceneFormat();
const SceneFormat& principledSceneFormat();

}  // namespace gonio::exports
