// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>

#include "core/export/export_files.h"
#include "core/export/shaders/shading_formulas.h"
#include "core/export/shaders/shading_models.h"
#include "core/export/target_table.h"
#include "core/models/fresnel.h"
#include "core/support/text.h"

namespace gonio::exports {

namespace {

constexpr double mtlxMinAlpha = 1e-4;

constexpr SurfaceLimit mtlxLimits[] = {
    {SurfaceField::baseColour, 0, 1}, {SurfaceField::metalness, 0, 1}, {SurfaceField::roughness, 0.03, 1},
    {SurfaceField::anisotropy, 0, 1}, {SurfaceField::rotation, -7, 7}, {SurfaceField::specularColour, 0, 1},
    {SurfaceField::ior, 1, 3},        {SurfaceField::coat, 0, 1},      {SurfaceField::coatRoughness, 0.03, 1},
};

double peakWidth(double alpha) { return std::clamp(alpha, mtlxMinAlpha, 1.0); }

/// A lobe without its Fresnel term, and its albedo for the viewer: masking knows the mean of both widths alone.
struct MtlxLobe {
  double value;
  GgxAlbedo albedo;

  MtlxLobe(const models::SurfaceGeometry& g, const GgxAlpha& alpha)
      : value(correlatedGgx(g, alpha, GgxAlpha(alpha.mean()))), albedo(ggxAlbedo(g.cosO, alpha.mean())) {}
  double compensated(double fresnel) const { return value * fresnel * scatteringCompensation(albedo, fresnel); }
  Rgb compensated(const Rgb& f) const { return {compensated(f.x), compensated(f.y), compensated(f.z)}; }
};

/// dielectric_bsdf of weight and tint 1, and the layer rule.
struct DielectricLayer {
  double value;
  double passed;  ///< what the layer lets through for this viewer

  DielectricLayer(const models::SurfaceGeometry& g, double ior, const GgxAlpha& alpha) {
    const MtlxLobe lobe(g, alpha);
    const double fresnel = models::fresnelDielectric(g.cosD, ior);
    value = lobe.compensated(fresnel);
    const double albedo = lobe.albedo.at(models::normalReflectanceFromIndex(ior));
    passed = 1 - albedo * scatteringCompensation(lobe.albedo, fresnel);
  }
};

struct OpenPbrFormula {
  static constexpr double coatIor = 1.6;
  SurfaceValues v;
  GgxAlpha alpha, coatAlpha;
  double ior;
  Rgb darkening;

  explicit OpenPbrFormula(const SurfaceValues& values) : v(values), alpha(1), coatAlpha(1) {
    const double r4 = std::pow(v.roughness, 4), coat4 = std::pow(v.coatRoughness, 4);
    const double roughness = glm::mix(v.roughness, std::pow(std::min(1.0, r4 + 2 * coat4), 0.25), v.coat);
    const double narrow = 1 - v.anisotropy, wide = roughness * roughness * std::sqrt(2 / (1 + narrow * narrow));
    alpha = GgxAlpha(peakWidth(wide), peakWidth(wide * narrow));
    coatAlpha = GgxAlpha(peakWidth(v.coatRoughness * v.coatRoughness));
    const double ratio = v.ior / coatIor;
    ior = glm::mix(v.ior, ratio > 1 ? ratio : 1 / ratio, v.coat);
    const double inside = 1 - (1 - models::normalReflectanceFromIndex(coatIor)) / (coatIor * coatIor);
    darkening = glm::mix(Rgb(1), (1 - inside) / (Rgb(1) - inside * v.baseColour), v.coat);
  }

  Rgb operator()(const models::SurfaceGeometry& g) const {
    const DielectricLayer layer(g, ior, alpha);
    const Rgb dielectric = layer.value * v.specularColour + layer.passed * v.baseColour / pi;
    const Rgb metal = MtlxLobe(g, alpha).compensated(tintedSchlick(g.cosD, v.baseColour, Rgb(1), v.specularColour));
    const Rgb base = darkening * glm::mix(dielectric, metal, v.metalness);
    if (!(v.coat > 0)) return base;
    const DielectricLayer coat(g, coatIor, coatAlpha);
    return v.coat * coat.value + (1 - v.coat * (1 - coat.passed)) * base;
  }
};

struct StandardSurfaceFormula {
  static constexpr double coatIor = 1.5, maxReflectivity = 0.99;
  SurfaceValues v;
  GgxAlpha alpha, coatAlpha;
  models::ComplexIndex index[3];

  explicit StandardSurfaceFormula(const SurfaceValues& values) : v(values), alpha(1), coatAlpha(1) {
    const double squared = v.roughness * v.roughness, aspect = std::sqrt(std::max(1e-4, 1 - v.anisotropy));
    alpha = GgxAlpha(peakWidth(squared / aspect), peakWidth(squared * aspect));
    coatAlpha = GgxAlpha(peakWidth(v.coatRoughness * v.coatRoughness));
    for (int c = 0; c < 3; ++c)
      index[c] = models::indexFromEdgeTint(std::min(maxReflectivity, v.baseColour[c]), v.specularColour[c]);
  }

  Rgb operator()(const models::SurfaceGeometry& g) const {
    const DielectricLayer layer(g, v.ior, alpha);
    const Rgb dielectric = layer.value * v.specularColour + layer.passed * v.baseColour / pi;
    Rgb fresnel;
    for (int c = 0; c < 3; ++c) fresnel[c] = models::fresnelConductor(g.cosD, index[c].eta, index[c].k);
    const Rgb base = glm::mix(dielectric, MtlxLobe(g, alpha).compensated(fresnel), v.metalness);
    if (!(v.coat > 0)) return base;
    const DielectricLayer coat(g, coatIor, coatAlpha);
    return v.coat * coat.value + (1 - v.coat * (1 - coat.passed)) * base;
  }
};

template <typename Formula>
std::unique_ptr<const Brdf> mtlxBrdf(const SurfaceValues& v) {
  return makeFormulaBrdf(Formula(v), {.isotropic = !(v.anisotropy > 0), .reciprocal = false, .rotation = v.rotation});
}

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
  MtlxNode& number(std::string_view input, double number) { return value(input, "float", sixDigitText(number)); }
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

const SurfaceShader& openPbrShader() {
  static const SurfaceShader shader{
      mtlxLimits, {.baseColour = Rgb(0.8), .roughness = 0.3, .coatRoughness = 0}, mtlxBrdf<OpenPbrFormula>};
  return shader;
}

const SurfaceShader& standardSurfaceShader() {
  static const SurfaceShader shader{
      mtlxLimits, {.baseColour = Rgb(0.8), .roughness = 0.2}, mtlxBrdf<StandardSurfaceFormula>};
  return shader;
}

std::unique_ptr<const Brdf> schlickLobesBrdf(const ReciprocalLobes& lobes) {
  return makeFormulaBrdf(
      [lobes](const models::SurfaceGeometry& g) {
        Rgb sum = lobes.diffuse / pi;
        for (const ReciprocalLobes::Lobe& lobe : lobes.lobes)
          sum += MtlxLobe(g, lobe.alpha).compensated(tintedSchlick(g.cosD, lobe.normal, lobe.edge, lobe.tint82));
        return sum;
      },
      {.isotropic = lobes.isIsotropic(), .reciprocal = false, .rotation = lobes.rotation});
}

std::string schlickLobesDocument(const ReciprocalLobes& lobes, const std::string& name, const std::string& origin) {
  const bool grain = !lobes.isIsotropic();
  std::string nodes = grain ? grainNodes(lobes.rotation) : "", sum = "diffuse";
  nodes += MtlxNode("oren_nayar_diffuse_bsdf", "diffuse", "BSDF").colour("color", lobes.diffuse).text();
  for (std::size_t j = 0; j < lobes.lobes.size(); ++j) {
    const ReciprocalLobes::Lobe& lobe = lobes.lobes[j];
    const std::string lobeName = "lobe" + std::to_string(j + 1), sumName = "sum" + std::to_string(j + 1);
    MtlxNode node("generalized_schlick_bsdf", lobeName, "BSDF");
    node.colour("color0", lobe.normal).colour("color82", lobe.tint82).colour("color90", lobe.edge);
    node.value("roughness", "vector2", sixDigitText(lobe.alpha.x) + ", " + sixDigitText(lobe.alpha.y));
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
          .icon = "target-lobes",
          .purpose = "Looks closest in programs that read MaterialX.",
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
      .icon = "target-coat",
      .purpose = "Gives an OpenPBR material that you can adjust further in programs that read MaterialX.",
      .description = "A MaterialX 1.39 document with one open_pbr_surface, which artists can edit further.",
      .limitations =
          "An approximation by a diffuse lobe, one highlight and a coat; isotropic, or anisotropic with one fixed "
          "brushing direction.",
      .suffixes = {openPbrSuffix},
      .make = [](const materials::EditedMaterial& source, const ExportOptions& options, const TaskControl& control) {
        return makeSurfaceExport(openPbrShader(), openPbrSuffix, openPbrDocument, source, options, control);
      }};
}

ExportTarget standardSurfaceTarget() {
  return {
      .id = "standard-surface",
      .label = "Standard Surface (MaterialX)",
      .icon = "target-layers",
      .purpose = "Gives a Standard Surface that you can adjust further in Arnold, Maya and 3ds Max.",
      .description = "A MaterialX 1.39 document with one standard_surface, for Arnold, Maya and 3ds Max.",
      .limitations =
          "An approximation by a diffuse lobe, one highlight and a coat; isotropic, or anisotropic with one fixed "
          "brushing direction.",
      .suffixes = {standardSuffix},
      .make = [](const materials::EditedMaterial& source, const ExportOptions& options, const TaskControl& control) {
        return makeSurfaceExport(standardSurfaceShader(), standardSuffix, standardSurfaceDocument, source, options,
                                 control);
      }};
}

}  // namespace gonio::exports
