// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>

namespace gonio::exports {

/// A Python script that makes a material in Blender 3.4 and later and gives it to the selected mesh, or saves it with
/// --background. @param origin, made for its first lines. @param description of the dictionary GONIO, in Python.
/// @param makeMaterial defines make_material(), which returns the material; it has node(tree, kinds, x, y).
std::string blenderMaterialScript(const std::string& origin, std::string_view made, const std::string& description,
                                  std::string_view makeMaterial);

}  // namespace gonio::exports
