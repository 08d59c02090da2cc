// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/math/image.h"
#include "core/rendering/scene.h"

namespace gonio::exports {

/// Files that show NAME's `.bsdf` files on a unit sphere in the environment of a scene under its camera, so that the
/// picture in the renderer is that of Gonio: a scene and its environment. NAME is without folders: the files lie in
/// one. Not in them: meshes, other lights and materials. @throws Error where the scene has no environment or the camera
/// is orthographic. Mitsuba 3: NAME_scene.xml and NAME_environment.exr, a latitude-longitude picture.
std::vector<MadeExport::Part> mitsubaScene(const Scene& scene, const std::string& name);
/// pbrt-v4: NAME_scene.pbrt and NAME_environment_octahedral.exr, by octahedralEnvironment().
std::vector<MadeExport::Part> pbrtScene(const Scene& scene, const std::string& name);

/// The environment as pbrt-v4 reads it: a square of `side` pixels in the equal-area octahedral mapping of Clarberg
/// 2008, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD", about the world's z axis, turned by `rotation`
/// (EnvironmentRotation). Bilinear: details finer than a pixel are lost.
Image octahedralEnvironment(const EnvironmentMap& environment, double rotation, int side);

}  // namespace gonio::exports
