// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/scene_files.h"

namespace gonio::exports {

/// NAME_scene.py of Blender 3.4 and later, which makes a scene for Cycles with the material of NAME_blender.py or of
/// NAME_principled.py, and NAME_environment.exr, a latitude-longitude picture. Blender's axes are z up, -y to the
/// viewer. Rectangles reflect from their backs too.
const SceneFormat& blenderSceneFormat();
const SceneFormat& principledSceneFormat();

}  // namespace gonio::exports
