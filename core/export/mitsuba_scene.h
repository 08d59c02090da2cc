// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/scene_files.h"

namespace gonio::exports {

/// NAME_scene.xml for Mitsuba 3 with NAME_rgb.bsdf, and NAME_environment.exr, a latitude-longitude map.
const SceneFormat& mitsubaSceneFormat();

}  // namespace gonio::exports
