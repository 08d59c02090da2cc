// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/blender_script.h"

namespace gonio::exports {

namespace {

/// Python reads a declaration of the encoding in the first two lines, so no name may occur in them.
constexpr const char* scriptStart = R"(# -*- coding: utf-8 -*-
# A material, made by Gonio: Scripting > Open > Run Script, with the object selected, or
#   blender --background --python THIS_FILE -- material.blend
)";

constexpr const char* nodeFunction = R"(

def node(tree, kinds, x, y):
    """A new node of the first kind that this version of Blender knows."""
    for kind in kinds:
        if hasattr(bpy.types, kind):
            made = tree.nodes.new(kind)
            made.location = (x, y)
            return made
    raise RuntimeError("Blender %s has none of the nodes %s" % (bpy.app.version_string, ", ".join(kinds)))
)";

constexpr const char* mainFunction = R"(

def main():
    material = make_material()
    active = bpy.context.view_layer.objects.active if not bpy.app.background else None
    if active is not None and active.type == 'MESH':
        active.data.materials.clear()
        active.data.materials.append(material)
    material.use_fake_user = True
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if arguments:
        bpy.ops.wm.save_as_mainfile(filepath=arguments[0])


if __name__ == "__main__":
    main()
)";

}  // namespace

std::string blenderMaterialScript(std::string_view content, const std::string& description,
                                  std::string_view makeMaterial) {
  return scriptStart + std::string("# ") + std::string(content) +
         "\nimport math\nimport sys\n\nimport bpy\n\nGONIO = " + description + "\n" + nodeFunction + "\n\n" +
         std::string(makeMaterial) + mainFunction;
}

}  // namespace gonio::exports
