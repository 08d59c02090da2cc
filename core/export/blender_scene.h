// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/scene_files.h"

namespace gonio::exports {

/// NAME_scene.py, a script for Blender 3.4 and later that creates a scene for Cycles with the material of
/// NAME_blender.py (blenderSceneFormat()) or NAME_principled.py (principledSceneFormat()), and NAME_environment.exr, a
/// latitude-longitude map. In Blender's axes z is up and -y points to the viewer. Rectangles also reflect from their
/// backs.
const SceneFormat& blenderSceneFormat();
const SceneFormat& principledSceneFormat();

}  // namespace gonio::exports
