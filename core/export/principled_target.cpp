// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/principled_target.h"

#include <algorithm>

#include "core/export/blender_scene.h"
#include "core/export/blender_script.h"
#include "core/export/principled_model.h"
#include "core/export/surface_target.h"
#include "core/io/json_text.h"

namespace gonio::exports {

namespace {

constexpr std::string_view principledSuffix = "_principled.py";

/// Sets the sockets by the names of this version of Blender.
constexpr const char* principledProgram = R"(def socket(shader, names):
    """The first of these inputs that this version of Blender has."""
    for name in names:
        if name in shader.inputs:
            return shader.inputs[name]
    raise RuntimeError("Blender %s has none of the inputs %s" % (bpy.app.version_string, ", ".join(names)))


def set_specular_tint(shader):
    """A colour since Blender 4.0, before a factor of the base colour's hue."""
    tint = shader.inputs["Specular Tint"]
    factor, base = GONIO["specular_tint"], GONIO["base_color"]
    if tint.type != 'RGBA':
        tint.default_value = factor
        return
    grey = 0.3 * base[0] + 0.6 * base[1] + 0.1 * base[2]
    hue = [channel / grey if grey > 0 else 1 for channel in base]
    tint.default_value = [1 - factor + factor * channel for channel in hue] + [1]


def set_coat(shader):
    """Blender 3 has a quarter of the coat that it is given."""
    if "Clearcoat" in shader.inputs:
        shader.inputs["Clearcoat"].default_value = GONIO["clearcoat"]
    else:
        shader.inputs["Coat Weight"].default_value = 0.25 * GONIO["clearcoat"]
    socket(shader, ["Coat Roughness", "Clearcoat Roughness"]).default_value = GONIO["clearcoat_roughness"]


def set_anisotropy(tree, shader):
    shader.inputs["Anisotropic"].default_value = GONIO["anisotropic"]
    shader.inputs["Anisotropic Rotation"].default_value = GONIO["anisotropic_rotation"]
    if GONIO["anisotropic"] > 0:
        tangent = node(tree, ["ShaderNodeTangent"], -300, -200)
        tangent.direction_type = 'UV_MAP'
        tree.links.new(tangent.outputs[0], shader.inputs["Tangent"])


def make_material():
    material = bpy.data.materials.new(GONIO["name"])
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader = node(tree, ["ShaderNodeBsdfPrincipled"], 0, 0)
    shader.distribution = 'GGX'
    shader.inputs["Base Color"].default_value = GONIO["base_color"] + [1]
    shader.inputs["Metallic"].default_value = GONIO["metallic"]
    shader.inputs["Roughness"].default_value = GONIO["roughness"]
    shader.inputs["IOR"].default_value = 1.5
    socket(shader, ["Specular IOR Level", "Specular"]).default_value = GONIO["specular"]
    set_specular_tint(shader)
    set_coat(shader)
    set_anisotropy(tree, shader)
    output = node(tree, ["ShaderNodeOutputMaterial"], 400, 0)
    tree.links.new(shader.outputs["BSDF"], output.inputs["Surface"])
    return material
)";

}  // namespace

std::string principledScript(const SurfaceValues& v, const std::string& name, const std::string& origin) {
  const nlohmann::ordered_json json{
      {"name", name},
      {"origin", origin},
      {"base_color", {float(v.baseColour.x), float(v.baseColour.y), float(v.baseColour.z)}},
      {"metallic", float(v.metalness)},
      {"roughness", float(v.roughness)},
      {"specular", float(v.specular)},
      {"specular_tint", float(v.specularTint)},
      {"anisotropic", float(v.anisotropy)},
      {"anisotropic_rotation", float(v.rotation / (2 * pi))},
      {"clearcoat", float(v.coat)},
      {"clearcoat_roughness", float(v.coatRoughness)}};
  return blenderMaterialScript("A Principled BSDF.", io::jsonText(json, 4), principledProgram);
}

ExportTarget principledTarget() {
  return {
      .id = "principled",
      .label = "Blender (Principled BSDF)",
      .description =
          "A Python script that creates a material from one Principled BSDF node, which artists can edit further "
          "and other programs can import: "
          "run it in Blender, or with blender --background --python.",
      .limitations =
          "An approximation by a diffuse lobe, one highlight and a coat; isotropic, or anisotropic with one fixed "
          "brushing direction. The stated accuracy is that of Blender 3.4; Blender 4 changed the shader of this "
          "node.",
      .suffixes = {principledSuffix},
      .scene = &principledSceneFormat(),
      .make = [](const materials::EditedMaterial& source, const ExportOptions& options, const TaskControl& control) {
        return makeSurfaceExport(
            principledShader(), principledSuffix,
            [](const materials::EditedMaterial& of, const SurfaceValues& values, const std::string& origin) {
              return principledScript(values, materials::plainName(of), origin);
            },
            source, options, control);
      }};
}

}  // namespace gonio::exports
