// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

namespace gonio::exports {

/// The Python script of a scene. @param description Python code of the dictionary SCENE: directions and positions with
/// z up; "environment" is omitted if there is none.
std::string blenderSceneProgram(const std::string& description);

}  // namespace gonio::exports
