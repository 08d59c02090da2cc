// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/scene_files.h"

namespace gonio::exports {

/// NAME_scene.pbrt for pbrt-v4 with NAME_spec.bsdf, and NAME_environment_octahedral.exr (octahedralEnvironment()). In
/// pbrt the environment is always visible, and Lambertian rectangles also reflect from their backs.
const SceneFormat& pbrtSceneFormat();

/// The environment as pbrt-v4 reads it: a square with `side` pixels per side in the equal-area octahedral mapping of
/// Clarberg 2008, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD", about the world's z axis, rotated by
/// `rotation` (EnvironmentRotation). Bilinear: details smaller than a pixel are lost.
Image octahedralEnvironment(const EnvironmentMap& environment, double rotation, int side);

}  // namespace gonio::exports
