// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>

namespace gonio::exports {

/// A Python script for Blender 3.4 and later that creates a material and assigns it to the active mesh; with
/// `blender --background --python SCRIPT -- FILE.blend` it saves the material to FILE.blend instead.
/// @param content a comment line: what the script creates. @param description Python code of the dictionary GONIO, with
/// all names and the origin of the material: text in comments could be code. @param makeMaterial Python code that
/// defines make_material(), which returns the material; it can call node(tree, kinds, x, y), which adds a node of the
/// first type in `kinds` that this version of Blender has.
std::string blenderMaterialScript(std::string_view content, const std::string& description,
                                  std::string_view makeMaterial);

}  // namespace gonio::exports
