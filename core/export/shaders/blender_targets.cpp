// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/export/export_files.h"
#include "core/export/scenes/scene_files.h"
#include "core/export/shaders/shading_models.h"
#include "core/export/target_table.h"
#include "core/io/json_text.h"

namespace gonio::exports {

namespace {

using Json = nlohmann::ordered_json;

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

std::string_view seriesText(BlenderVersion blender) {
  return blender == BlenderVersion::v3 ? "Blender 3" : "Blender 4";
}

BlenderVersion versionOf(const ExportOptions& options) {
  return options.blender == 3 ? BlenderVersion::v3 : BlenderVersion::v4;
}

/// The origin with the series of Blender that the accuracy is for.
std::string blenderOrigin(const materials::EditedMaterial& source, double snr, BlenderVersion blender) {
  return originText(source, snr) + " For " + std::string(seriesText(blender)) + ".";
}

/// A Python script for Blender 3.4 and later that creates a material and assigns it to the active mesh; with
/// `blender --background --python SCRIPT -- FILE.blend` it saves the material to FILE.blend instead.
/// @param content a comment line: what the script creates. @param description Python code of the dictionary GONIO, with
/// all names and the origin of the material: text in comments could be code. @param makeMaterial Python code that
/// defines make_material(), which returns the material; it can call node(tree, kinds, x, y), which adds a node of the
/// first type in `kinds` that this version of Blender has.
std::string blenderMaterialScript(const std::string& content, const std::string& description,
                                  std::string_view makeMaterial) {
  return scriptStart + std::string("# ") + content +
         "\nimport math\nimport sys\n\nimport bpy\n\nGONIO = " + description + "\n" + nodeFunction + "\n\n" +
         std::string(makeMaterial) + mainFunction;
}

/// From few nodes to many: the first that reaches the SNR is taken. A colour ramp has 32 stops at most.
constexpr ViewLobesSize viewLobesSizes[] = {{1, 8}, {2, 12}, {4, 16}, {6, 24}, {9, 32}};

/// Makes the node graph of GONIO.
constexpr const char* lobesProgram = R"(def viewer_angle(tree):
    """The socket of the viewer's polar angle, 0 at the normal and 1 at the horizon."""
    geometry = node(tree, ["ShaderNodeNewGeometry"], -1100, 0)
    dot = node(tree, ["ShaderNodeVectorMath"], -920, 0)
    dot.operation = 'DOT_PRODUCT'
    tree.links.new(geometry.outputs["Normal"], dot.inputs[0])
    tree.links.new(geometry.outputs["Incoming"], dot.inputs[1])
    angle = node(tree, ["ShaderNodeMath"], -740, 0)
    angle.operation = 'ARCCOSINE'
    angle.use_clamp = False
    tree.links.new(dot.outputs["Value"], angle.inputs[0])
    scaled = node(tree, ["ShaderNodeMath"], -560, 0)
    scaled.operation = 'MULTIPLY'
    scaled.inputs[1].default_value = 2 / math.pi
    tree.links.new(angle.outputs[0], scaled.inputs[0])
    return scaled.outputs[0]


def colour(tree, angle, weights, y):
    """The socket of the weights, [r, g, b] at GONIO["positions"]: a ramp of at most 1 times the largest weight."""
    peak = max(max(weight) for weight in weights)
    ramp = node(tree, ["ShaderNodeValToRGB"], -360, y)
    ramp.color_ramp.interpolation = 'LINEAR'
    stops = ramp.color_ramp.elements
    while len(stops) > 1:
        stops.remove(stops[-1])
    for index, (position, weight) in enumerate(zip(GONIO["positions"], weights)):
        stop = stops[0] if index == 0 else stops.new(position)
        stop.position = position
        stop.color = [channel / peak for channel in weight] + [1]
    tree.links.new(angle, ramp.inputs["Fac"])
    times = node(tree, ["ShaderNodeVectorMath"], -60, y)
    times.operation = 'MULTIPLY'
    times.inputs[1].default_value = (peak, peak, peak)
    tree.links.new(ramp.outputs["Color"], times.inputs[0])
    return times.outputs["Vector"]


def make_material():
    material = bpy.data.materials.new(GONIO["name"])
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    angle = viewer_angle(tree)
    total = None
    for index, lobe in enumerate(GONIO["lobes"]):
        y = -280 * index
        if lobe["alpha"] is None:
            closure = node(tree, ["ShaderNodeBsdfDiffuse"], 140, y)
        else:
            closure = node(tree, ["ShaderNodeBsdfGlossy", "ShaderNodeBsdfAnisotropic"], 140, y)
            closure.distribution = 'GGX'
            closure.inputs["Roughness"].default_value = math.sqrt(lobe["alpha"])
        tree.links.new(colour(tree, angle, lobe["weights"], y), closure.inputs["Color"])
        if total is None:
            total = closure.outputs["BSDF"]
            continue
        sum_ = node(tree, ["ShaderNodeAddShader"], 360 + 160 * index, y)
        tree.links.new(total, sum_.inputs[0])
        tree.links.new(closure.outputs["BSDF"], sum_.inputs[1])
        total = sum_.outputs["Shader"]
    output = node(tree, ["ShaderNodeOutputMaterial"], 560 + 160 * len(GONIO["lobes"]), 0)
    if total is not None:
        tree.links.new(total, output.inputs["Surface"])
    return material
)";

Json lobeJson(const Json& alpha, const std::vector<Rgb>& weights) {
  Json rows = Json::array();
  for (const Rgb& weight : weights) rows.push_back({float(weight.x), float(weight.y), float(weight.z)});
  return {{"alpha", alpha}, {"weights", rows}};
}

bool isBlack(const std::vector<Rgb>& weights) {
  return std::ranges::all_of(weights, [](const Rgb& weight) { return !(maxChannel(weight) > 0); });
}

/// JSON as Python reads it.
std::string pythonText(const Json& json) {
  std::string text = io::jsonText(json);
  for (std::size_t at = 0; (at = text.find("\"alpha\":null", at)) != std::string::npos;)
    text.replace(at, std::strlen("\"alpha\":null"), "\"alpha\":None");
  for (std::size_t at = 0; (at = text.find("{\"alpha\"", at)) != std::string::npos; at += 10) text.insert(at, "\n    ");
  return text;
}

ExportResult makeScript(const materials::EditedMaterial& source, const ExportOptions& options,
                        const TaskControl& control) {
  const rendering::RenderedComparison comparison = materials::comparisonOf(source, options, control.between(0, 0.2));
  ExportResult made;
  ViewLobes best;
  double done = 0.2;
  for (ViewLobesSize size : viewLobesSizes) {
    size.blender = versionOf(options);
    const TaskControl part = control.between(done, done + 0.16);
    ViewLobes lobes = fitViewLobes(*source.shown.brdf, size, part.between(0, 0.5));
    auto brdf = viewLobesBrdf(lobes);
    const double snr = comparison.signalToNoiseRatio(comparison.render(*brdf, part.between(0.5, 1)));
    done += 0.16;
    if (made.brdf && !(snr > made.snr)) continue;
    made.brdf = std::move(brdf);
    made.snr = snr;
    best = std::move(lobes);
    if (snr >= options.snr) break;
  }
  made.facts = {{"lobes", "GGX lobes", best.alphas.size()}, {"knots", "Viewing angles", best.thetas.size()}};
  if (!source.shown.brdf->isIsotropic()) made.warnings.push_back(meanAzimuthWarning());
  made.parts.push_back(textPart(
      "_blender.py", blenderScript(best, materials::plainName(source), blenderOrigin(source, made.snr, best.blender))));
  return made;
}

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
    if isinstance(factor, list):
        tint.default_value = factor + [1] if tint.type == 'RGBA' else 0
        return
    if tint.type != 'RGBA':
        tint.default_value = factor
        return
    grey = 0.3 * base[0] + 0.6 * base[1] + 0.1 * base[2]
    hue = [channel / grey if grey > 0 else 1 for channel in base]
    tint.default_value = [1 - factor + factor * channel for channel in hue] + [1]


def set_coat(shader):
    """Blender 3 has a quarter of the coat that it is given."""
    if "Clearcoat" in shader.inputs:
        shader.inputs["Clearcoat"].default_value = min(1, 4 * GONIO["coat_weight"])
    else:
        shader.inputs["Coat Weight"].default_value = GONIO["coat_weight"]
    socket(shader, ["Coat Roughness", "Clearcoat Roughness"]).default_value = GONIO["coat_roughness"]


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

std::string blenderScript(const ViewLobes& lobes, const std::string& name, const std::string& origin) {
  Json json{{"name", name}, {"origin", origin}, {"positions", Json::array()}, {"lobes", Json::array()}};
  for (const double theta : lobes.thetas) json["positions"].push_back(float(theta / halfPi));
  if (!isBlack(lobes.weights[0])) json["lobes"].push_back(lobeJson(nullptr, lobes.weights[0]));
  for (std::size_t j = 0; j < lobes.alphas.size(); ++j)
    if (!isBlack(lobes.weights[j + 1])) json["lobes"].push_back(lobeJson(lobes.alphas[j], lobes.weights[j + 1]));
  return blenderMaterialScript("One Diffuse and several Glossy nodes, each weighted by the viewing angle, for " +
                                   std::string(seriesText(lobes.blender)) + ".",
                               pythonText(json), lobesProgram);
}

ExportTarget blenderTarget() {
  return {.id = "blender",
          .label = "Blender (Cycles)",
          .icon = "target-script",
          .purpose = "Looks closest in Blender with Cycles, as a network of nodes.",
          .description =
              "A Python script that creates a material from a Diffuse and several Glossy nodes, each weighted by the "
              "viewing angle: run it in Blender, or with blender --background --python.",
          .limitations =
              "An approximation by GGX lobes with colours that depend only on the viewing angle; isotropic. The stated "
              "accuracy is that of Blender 4; Blender 3 has another masking term, so results differ near the horizon.",
          .suffixes = {"_blender.py"},
          .usesSnr = true,
          .scene = &blenderSceneFormat(),
          .make = makeScript};
}

std::string principledScript(const SurfaceValues& v, BlenderVersion blender, const std::string& name,
                             const std::string& origin) {
  const bool three = blender == BlenderVersion::v3;
  const Rgb& tint = v.specularColour;
  const Json json{
      {"name", name},
      {"origin", origin},
      {"base_color", {float(v.baseColour.x), float(v.baseColour.y), float(v.baseColour.z)}},
      {"metallic", float(v.metalness)},
      {"roughness", float(v.roughness)},
      {"specular", float(v.specular)},
      {"specular_tint", three ? Json(float(v.specularTint)) : Json{float(tint.x), float(tint.y), float(tint.z)}},
      {"anisotropic", float(v.anisotropy)},
      {"anisotropic_rotation", float(v.rotation / (2 * pi))},
      {"coat_weight", float(three ? v.coat / 4 : v.coat)},
      {"coat_roughness", float(v.coatRoughness)}};
  return blenderMaterialScript("A Principled BSDF with values for " + std::string(seriesText(blender)) + ".",
                               io::jsonText(json, 4), principledProgram);
}

namespace {

/// principledScript() as a SurfaceText.
template <BlenderVersion blender>
std::string principledText(const SurfaceValues& values, const std::string& name, const std::string& origin) {
  return principledScript(values, blender, name, origin + " For " + std::string(seriesText(blender)) + ".");
}

}  // namespace

ExportTarget principledTarget() {
  return {
      .id = "principled",
      .label = "Blender (Principled BSDF)",
      .icon = "target-nodes",
      .purpose = "Gives one Principled BSDF in Blender, which you can adjust further.",
      .description =
          "A Python script that creates a material from one Principled BSDF node, which artists can edit further "
          "and other programs can import: "
          "run it in Blender, or with blender --background --python.",
      .limitations =
          "An approximation by a diffuse lobe, one highlight and a coat; isotropic, or anisotropic with one fixed "
          "brushing direction. The values and the stated accuracy are for Blender 4, whose shader of this node differs "
          "from that of Blender 3.",
      .suffixes = {principledSuffix},
      .scene = &principledSceneFormat(),
      .make = [](const materials::EditedMaterial& source, const ExportOptions& options, const TaskControl& control) {
        const SurfaceText text = versionOf(options) == BlenderVersion::v3
                                     ? SurfaceText(principledText<BlenderVersion::v3>)
                                     : SurfaceText(principledText<BlenderVersion::v4>);
        return makeSurfaceExport(principledShader(versionOf(options)), principledSuffix, text, source, options,
                                 control);
      }};
}

}  // namespace gonio::exports
