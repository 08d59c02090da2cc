// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/export/shaders/shading_formulas.h"
#include "core/export/shaders/shading_models.h"
#include "core/export/target_table.h"
#include "core/io/byte_source.h"
#include "core/io/json_text.h"

namespace gonio::exports {

namespace {

constexpr double gltfDielectricF0 = 0.04, gltfMinAlpha = 1e-4;

// The limit of specularColour: 25 makes a dielectric of index 1.5 a mirror.
constexpr SurfaceLimit gltfLimits[] = {
    {SurfaceField::baseColour, 0, 1},       {SurfaceField::metalness, 0, 1},
    {SurfaceField::roughness, 0.03, 1},     {SurfaceField::anisotropy, 0, 1},
    {SurfaceField::rotation, -7, 7},        {SurfaceField::specularColour, 0, 25},
    {SurfaceField::specular, 0, 1},         {SurfaceField::coat, 0, 1},
    {SurfaceField::coatRoughness, 0.03, 1}, {SurfaceField::sheenColour, 0, 1},
    {SurfaceField::sheenRoughness, 0.1, 1},
};

struct GltfFormula {
  SurfaceValues v;
  GgxAlpha alpha, coatAlpha;

  explicit GltfFormula(const SurfaceValues& values) : v(values), alpha(1), coatAlpha(1) {
    const double a = std::max(gltfMinAlpha, v.roughness * v.roughness);
    alpha = GgxAlpha(glm::mix(a, 1.0, v.anisotropy * v.anisotropy), a);
    coatAlpha = GgxAlpha(std::max(gltfMinAlpha, v.coatRoughness * v.coatRoughness));
  }

  Rgb operator()(const models::SurfaceGeometry& g) const {
    Rgb value = base(g);
    if (maxChannel(v.sheenColour) > 0) value = sheen(g, value);
    if (!(v.coat > 0)) return value;
    const double weight = v.coat * glm::mix(gltfDielectricF0, 1.0, schlickWeight(g.cosO));
    return glm::mix(value, Rgb(correlatedGgx(g, coatAlpha)), weight);
  }

 private:
  Rgb base(const models::SurfaceGeometry& g) const {
    const double highlight = correlatedGgx(g, alpha), s = schlickWeight(g.cosD);
    const Rgb metal = highlight * glm::mix(v.baseColour, Rgb(1), s);
    const Rgb f0 = glm::min(gltfDielectricF0 * v.specularColour, Rgb(1));
    const Rgb reflected = v.specular * glm::mix(f0, Rgb(1), s);
    const Rgb dielectric = (1 - maxChannel(reflected)) * v.baseColour / pi + reflected * highlight;
    return glm::mix(dielectric, metal, v.metalness);
  }

  Rgb sheen(const models::SurfaceGeometry& g, const Rgb& below) const {
    const double alphaSheen = v.sheenRoughness * v.sheenRoughness, strength = maxChannel(v.sheenColour);
    const double albedo = std::max(charlieAlbedo(g.cosI, alphaSheen), charlieAlbedo(g.cosO, alphaSheen));
    const double fibres = charlieDensity(g.sin2H, alphaSheen) / (4 * (g.cosI + g.cosO - g.cosI * g.cosO));
    return fibres * v.sheenColour + (1 - strength * albedo) * below;
  }
};

using GltfJson = nlohmann::ordered_json;

enum GltfConstant { floatComponents = 5126, shortComponents = 5123, vertexBuffer = 34962, indexBuffer = 34963 };

/// The unit sphere about the y axis, as glTF has it: tangents along growing longitude.
class GltfSphere {
 public:
  explicit GltfSphere(bool withTangents) {
    std::vector<float> positions, tangents, coordinates;
    for (int i = 0; i <= rings; ++i)
      for (int j = 0; j <= segments; ++j) {
        const double u = double(j) / segments, v = double(i) / rings, theta = v * pi, phi = 2 * pi * u;
        // The poles exactly: sin(pi) is not 0.
        const double sine = i == 0 || i == rings ? 0 : std::sin(theta);
        for (const double x : {sine * std::sin(phi), std::cos(theta), sine * std::cos(phi)})
          positions.push_back(float(x));
        for (const double x : {std::cos(phi), 0.0, -std::sin(phi), 1.0}) tangents.push_back(float(x));
        coordinates.push_back(float(u));
        coordinates.push_back(float(v));
      }
    attributes_["POSITION"] = addFloats(positions, "VEC3", 3);
    accessors_.back()["min"] = {-extentOf(positions, 0), -1, -extentOf(positions, 2)};
    accessors_.back()["max"] = {extentOf(positions, 0), 1, extentOf(positions, 2)};
    attributes_["NORMAL"] = addFloats(positions, "VEC3", 3);
    attributes_["TEXCOORD_0"] = addFloats(coordinates, "VEC2", 2);
    if (withTangents) attributes_["TANGENT"] = addFloats(tangents, "VEC4", 4);
    indices_ = add(triangles(), indexBuffer, shortComponents, "SCALAR", 1);
  }

  void addTo(GltfJson& document) const {
    document["meshes"] = {
        {{"name", "sphere"}, {"primitives", {{{"attributes", attributes_}, {"indices", indices_}, {"material", 0}}}}}};
    document["accessors"] = accessors_;
    document["bufferViews"] = views_;
    document["buffers"] = {
        {{"byteLength", bytes_.size()},
         {"uri", "data:application/octet-stream;base64," + io::base64Text(std::as_bytes(std::span(bytes_)))}}};
  }

 private:
  static constexpr int rings = 32, segments = 64;

  static double extentOf(const std::vector<float>& positions, std::size_t axis) {
    float largest = 0;
    for (std::size_t i = axis; i < positions.size(); i += 3) largest = std::max(largest, std::abs(positions[i]));
    return double(largest);
  }

  /// Counter-clockwise seen from outside.
  static std::vector<std::uint16_t> triangles() {
    std::vector<std::uint16_t> indices;
    const auto vertex = [](int i, int j) { return std::uint16_t(i * (segments + 1) + j); };
    for (int i = 0; i < rings; ++i)
      for (int j = 0; j < segments; ++j) {
        if (i > 0)
          for (const auto v : {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)}) indices.push_back(v);
        if (i + 1 < rings)
          for (const auto v : {vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)}) indices.push_back(v);
      }
    return indices;
  }

  std::size_t addFloats(const std::vector<float>& values, const char* type, std::size_t components) {
    return add(values, vertexBuffer, floatComponents, type, components);
  }
  template <typename Number>
  std::size_t add(const std::vector<Number>& values, int target, int componentType, const char* type,
                  std::size_t components) {
    const std::size_t size = values.size() * sizeof(Number), offset = bytes_.size();
    bytes_.resize(offset + size);
    std::memcpy(bytes_.data() + offset, values.data(), size);
    views_.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}, {"target", target}});
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", componentType},
                          {"count", values.size() / components},
                          {"type", type}});
    return accessors_.size() - 1;
  }

  std::vector<std::uint8_t> bytes_;
  GltfJson attributes_, accessors_ = GltfJson::array(), views_ = GltfJson::array();
  std::size_t indices_ = 0;
};

GltfJson gltfColour(const Rgb& colour) { return {float(colour.x), float(colour.y), float(colour.z)}; }

GltfJson gltfExtensions(const SurfaceValues& v) {
  GltfJson extensions = GltfJson::object();
  if (v.specular != 1 || v.specularColour != Rgb(1))
    extensions["KHR_materials_specular"] = {{"specularFactor", float(v.specular)},
                                            {"specularColorFactor", gltfColour(v.specularColour)}};
  if (v.coat > 0)
    extensions["KHR_materials_clearcoat"] = {{"clearcoatFactor", float(v.coat)},
                                             {"clearcoatRoughnessFactor", float(v.coatRoughness)}};
  if (maxChannel(v.sheenColour) > 0)
    extensions["KHR_materials_sheen"] = {{"sheenColorFactor", gltfColour(v.sheenColour)},
                                         {"sheenRoughnessFactor", float(v.sheenRoughness)}};
  if (v.anisotropy > 0)
    extensions["KHR_materials_anisotropy"] = {{"anisotropyStrength", float(v.anisotropy)},
                                              {"anisotropyRotation", float(v.rotation)}};
  return extensions;
}

}  // namespace

const SurfaceShader& gltfShader() {
  static const SurfaceShader shader{
      gltfLimits,
      {.baseColour = Rgb(1), .metalness = 1, .roughness = 1, .coatRoughness = 0, .sheenRoughness = 0},
      [](const SurfaceValues& v) {
        return makeFormulaBrdf(GltfFormula(v),
                               {.isotropic = !(v.anisotropy > 0), .reciprocal = !(v.coat > 0), .rotation = v.rotation});
      }};
  return shader;
}

std::string gltfDocument(const SurfaceValues& values, const std::string& name, const std::string& origin) {
  const GltfJson extensions = gltfExtensions(values);
  GltfJson base = gltfColour(values.baseColour);
  base.push_back(1);
  GltfJson material{{"name", name},
                    {"pbrMetallicRoughness",
                     {{"baseColorFactor", base},
                      {"metallicFactor", float(values.metalness)},
                      {"roughnessFactor", float(values.roughness)}}}};
  if (!extensions.empty()) material["extensions"] = extensions;
  GltfJson document{{"asset", {{"version", "2.0"}, {"generator", "Gonio"}, {"extras", {{"origin", origin}}}}}};
  for (const auto& [extension, content] : extensions.items()) document["extensionsUsed"].push_back(extension);
  document["scene"] = 0;
  document["scenes"] = {{{"nodes", {0}}}};
  document["nodes"] = {{{"name", name}, {"mesh", 0}}};
  document["materials"] = GltfJson::array({material});
  GltfSphere(values.anisotropy > 0).addTo(document);
  return io::jsonText(document, 1) + "\n";
}

ExportTarget gltfTarget() {
  return {
      .id = "gltf",
      .label = "glTF 2.0",
      .icon = "target-cube",
      .purpose = "Shows in web viewers and game engines, and can be imported into Blender.",
      .description =
          "A sphere with a metallic-roughness material, for three.js, Babylon.js, game engines and Blender's import. "
          "Extensions for specular, clearcoat, sheen and anisotropy are included where they have an effect.",
      .limitations =
          "An approximation by one highlight, a coat and a sheen; isotropic, or anisotropic with one fixed brushing "
          "direction. The stated accuracy is that of the formula in appendix B of the glTF 2.0 specification; viewers "
          "may approximate it.",
      .suffixes = {".gltf"},
      .make = [](const materials::EditedMaterial& source, const ExportOptions& options, const TaskControl& control) {
        return makeSurfaceExport(gltfShader(), ".gltf", gltfDocument, source, options, control);
      }};
}

}  // namespace gonio::exports
