// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/scene_files.h"

namespace gonio::exports {

/// NAME_scene.pbrt of pbrt-v4 with NAME_spec.bsdf, and NAME_environment_octahedral.exr, by octahedralEnvironment().
/// pbrt always shows the environment, and Lambertian rectangles reflect from their backs too.
const SceneFormat& pbrtSceneFormat();

/// The environment as pbrt-v4 reads it: a square of `side` pixels in the equal-area octahedral mapping of Clarberg
/// 2008, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD", about the world's z axis, turned by `rotation`
/// (EnvironmentRotation). Bilinear: details finer than a pixel are lost.
Image octahedralEnvironment(const EnvironmentMap& environment, double rotation, int side);

}  // namespace gonio::exports
