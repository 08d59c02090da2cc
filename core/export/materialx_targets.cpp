// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/materialx_targets.h"

#include <algorithm>

#include "core/export/export_report.h"
#include "core/export/lobes_export.h"
#include "core/export/materialx_models.h"
#include "core/export/surface_target.h"
#include "core/support/plain_text.h"

namespace gonio::exports {

namespace {

constexpr std::string_view lobesSuffix = ".mtlx", openPbrSuffix = "_openpbr.mtlx",
                           standardSuffix = "_standard_surface.mtlx";
/// Numbers of lobes, the first that reaches the SNR is taken.
constexpr std::size_t mtlxLobeCounts[] = {1, 2, 4};

/// Names of elements are letters, digits and _, and do not begin with a digit.
std::string elementName(const std::string& name) {
  std::string result = "material_";
  for (const char c : name) {
    const bool isName = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    result += isName ? c : '_';
  }
  return result;
}

/// XML comments do not contain two hyphens.
std::string xmlComment(const std::string& origin) {
  std::string text = plainText(origin);
  for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos;) text[at + 1] = ' ';
  return "  <!-- " + text + " -->\n";
}

/// A node of a document with its inputs.
class MtlxNode {
 public:
  MtlxNode(std::string_view category, std::string name, std::string_view type)
      : end_("  </" + std::string(category) + ">\n"),
        text_("  <" + std::string(category) + " name=\"" + std::move(name) + "\" type=\"" + std::string(type) +
              "\">\n") {}

  MtlxNode& value(std::string_view input, std::string_view type, const std::string& value) {
    return add(input, type, "value", value);
  }
  MtlxNode& number(std::string_view input, double number) { return value(input, "float", decimalText(number)); }
  MtlxNode& colour(std::string_view input, const Rgb& colour) { return value(input, "color3", colourText(colour)); }
  MtlxNode& node(std::string_view input, std::string_view type, const std::string& name) {
    return add(input, type, "nodename", name);
  }
  std::string text() const { return text_ + end_; }

 private:
  MtlxNode& add(std::string_view input, std::string_view type, std::string_view attribute, const std::string& content) {
    text_ += "    <input name=\"" + std::string(input) + "\" type=\"" + std::string(type) + "\" " +
             std::string(attribute) + "=\"" + content + "\" />\n";
    return *this;
  }

  std::string end_, text_;
};

std::string mtlxDocument(const std::string& origin, const std::string& nodes) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<materialx version=\"1.39\" colorspace=\"lin_rec709\">\n" +
         xmlComment(origin) + nodes + "</materialx>\n";
}

std::string surfaceMaterial(const std::string& name, const std::string& shader) {
  return MtlxNode("surfacematerial", elementName(name), "material")
      .node("surfaceshader", "surfaceshader", shader)
      .text();
}

/// Nodes "grain": the tangent, turned about the normal. @param rotation rad.
std::string grainNodes(double rotation) {
  return MtlxNode("normal", "normal", "vector3").value("space", "string", "world").text() +
         MtlxNode("tangent", "tangent", "vector3").value("space", "string", "world").text() +
         MtlxNode("rotate3d", "grain", "vector3")
             .node("in", "vector3", "tangent")
             .number("amount", degrees(rotation))
             .node("axis", "vector3", "normal")
             .text();
}

ExportResult makeSchlickLobes(const materials::EditedMaterial& source, const ExportOptions& options,
                              const TaskControl& control) {
  auto [made, lobes] = makeLobesExport(mtlxLobeCounts, schlickLobesBrdf, source, options, control);
  made.parts.push_back(
      textPart(lobesSuffix, schlickLobesDocument(lobes, materials::plainName(source), originText(source, made.snr))));
  return std::move(made);
}

}  // namespace

std::string schlickLobesDocument(const ReciprocalLobes& lobes, const std::string& name, const std::string& origin) {
  const bool grain = !lobes.isIsotropic();
  std::string nodes = grain ? grainNodes(lobes.rotation) : "", sum = "diffuse";
  nodes += MtlxNode("oren_nayar_diffuse_bsdf", "diffuse", "BSDF").colour("color", lobes.diffuse).text();
  for (std::size_t j = 0; j < lobes.lobes.size(); ++j) {
    const ReciprocalLobes::Lobe& lobe = lobes.lobes[j];
    const std::string lobeName = "lobe" + std::to_string(j + 1), sumName = "sum" + std::to_string(j + 1);
    MtlxNode node("generalized_schlick_bsdf", lobeName, "BSDF");
    node.colour("color0", lobe.normal).colour("color82", lobe.tint82).colour("color90", lobe.edge);
    node.value("roughness", "vector2", decimalText(lobe.alpha.x) + ", " + decimalText(lobe.alpha.y));
    if (grain) node.node("tangent", "vector3", "grain");
    nodes += node.text();
    nodes += MtlxNode("add", sumName, "BSDF").node("in1", "BSDF", sum).node("in2", "BSDF", lobeName).text();
    sum = sumName;
  }
  nodes += MtlxNode("surface", "surface", "surfaceshader").node("bsdf", "BSDF", sum).text();
  return mtlxDocument(origin, nodes + surfaceMaterial(name, "surface"));
}

std::string openPbrDocument(const SurfaceValues& v, const std::string& name, const std::string& origin) {
  MtlxNode node("open_pbr_surface", "surface", "surfaceshader");
  node.colour("base_color", v.baseColour).number("base_metalness", v.metalness);
  node.colour("specular_color", v.specularColour).number("specular_roughness", v.roughness);
  node.number("specular_ior", v.ior);
  node.number("coat_weight", v.coat).number("coat_roughness", v.coatRoughness);
  if (v.anisotropy > 0)
    node.number("specular_roughness_anisotropy", v.anisotropy).node("geometry_tangent", "vector3", "grain");
  return mtlxDocument(
      origin, (v.anisotropy > 0 ? grainNodes(v.rotation) : "") + node.text() + surfaceMaterial(name, "surface"));
}

std::string standardSurfaceDocument(const SurfaceValues& v, const std::string& name, const std::string& origin) {
  MtlxNode node("standard_surface", "surface", "surfaceshader");
  node.number("base", 1).colour("base_color", v.baseColour).number("metalness", v.metalness);
  node.colour("specular_color", v.specularColour).number("specular_roughness", v.roughness);
  node.number("specular_IOR", v.ior);
  if (v.anisotropy > 0)
    node.number("specular_anisotropy", v.anisotropy).number("specular_rotation", v.rotation / (2 * pi));
  node.number("coat", v.coat).number("coat_roughness", v.coatRoughness);
  return mtlxDocument(origin, node.text() + surfaceMaterial(name, "surface"));
}

ExportTarget materialXTarget() {
  return {.id = "materialx",
          .label = "MaterialX (lobes)",
          .description =
              "A MaterialX 1.39 document that adds a diffuse lobe and up to four generalized_schlick_bsdf lobes: the "
              "closest approximation of a measured material in MaterialX.",
          .limitations =
              "An approximation by GGX lobes with a colour at 0, 82 and 90 degrees each; isotropic, or anisotropic "
              "with one fixed brushing direction. Multiple scattering is compensated as in MaterialX.",
          .suffixes = {lobesSuffix},
          .usesSnr = true,
          .make = makeSchlickLobes};
}

ExportTarget openPbrTarget() {
  return {
      .id = "openpbr",
      .label = "OpenPBR (MaterialX)",
      .description = "A MaterialX 1.39 document with one open_pbr_surface, which artists can edit further.",
      .limitations =
          "An approximation by a diffuse lobe, one highlight and a coat; isotropic, or anisotropic with one fixed "
          "brushing direction.",
      .suffixes = {openPbrSuffix},
      .make = [](const materials::EditedMaterial& source, const ExportOptions& options, const TaskControl& control) {
        return makeSurfaceExport(
            openPbrShader(), openPbrSuffix,
            [](const materials::EditedMaterial& of, const SurfaceValues& values, const std::string& origin) {
              return openPbrDocument(values, materials::plainName(of), origin);
            },
            source, options, control);
      }};
}

ExportTarget standardSurfaceTarget() {
  return {
      .id = "standard-surface",
      .label = "Standard Surface (MaterialX)",
      .description = "A MaterialX 1.39 document with one standard_surface, for Arnold, Maya and 3ds Max.",
      .limitations =
          "An approximation by a diffuse lobe, one highlight and a coat; isotropic, or anisotropic with one fixed "
          "brushing direction.",
      .suffixes = {standardSuffix},
      .make = [](const materials::EditedMaterial& source, const ExportOptions& options, const TaskControl& control) {
        return makeSurfaceExport(
            standardSurfaceShader(), standardSuffix,
            [](const materials::EditedMaterial& of, const SurfaceValues& values, const std::string& origin) {
              return standardSurfaceDocument(values, materials::plainName(of), origin);
            },
            source, options, control);
      }};
}

}  // namespace gonio::exports
