// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/blender_target.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/export/blender_scene.h"
#include "core/export/blender_script.h"
#include "core/export/export_report.h"
#include "core/io/json_text.h"

namespace gonio::exports {

namespace {

using Json = nlohmann::ordered_json;

/// From few nodes to many: the first that reaches the SNR is taken. A colour ramp has 32 stops at most.
constexpr ViewLobesSize sizes[] = {{1, 8}, {2, 12}, {4, 16}, {6, 24}, {9, 32}};

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
  const RenderedComparison comparison = materials::comparisonOf(source, options, control.between(0, 0.2));
  ExportResult made;
  ViewLobes best;
  double done = 0.2;
  for (const ViewLobesSize& size : sizes) {
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
  made.parts.push_back(
      textPart("_blender.py", blenderScript(best, materials::plainName(source), originText(source, made.snr))));
  return made;
}

}  // namespace

std::string blenderScript(const ViewLobes& lobes, const std::string& name, const std::string& origin) {
  Json json{{"name", name}, {"origin", origin}, {"positions", Json::array()}, {"lobes", Json::array()}};
  for (const double theta : lobes.thetas) json["positions"].push_back(float(theta / halfPi));
  if (!isBlack(lobes.weights[0])) json["lobes"].push_back(lobeJson(nullptr, lobes.weights[0]));
  for (std::size_t j = 0; j < lobes.alphas.size(); ++j)
    if (!isBlack(lobes.weights[j + 1])) json["lobes"].push_back(lobeJson(lobes.alphas[j], lobes.weights[j + 1]));
  return blenderMaterialScript("One Diffuse and several Glossy nodes, each weighted by the viewing angle.",
                               pythonText(json), lobesProgram);
}

ExportTarget blenderTarget() {
  return {.id = "blender",
          .label = "Blender (Cycles)",
          .description =
              "A Python script that creates a material from a Diffuse and several Glossy nodes, each weighted by the "
              "viewing angle: run it in Blender, or with blender --background --python.",
          .limitations =
              "An approximation by GGX lobes with colours that depend only on the viewing angle; isotropic. The stated "
              "accuracy is that of Blender 3.4; later versions use a different masking term, so results differ "
              "near the horizon.",
          .suffixes = {"_blender.py"},
          .usesSnr = true,
          .scene = &blenderSceneFormat(),
          .make = makeScript};
}

}  // namespace gonio::exports
