// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/gltf_model.h"

#include <algorithm>

#include "core/export/formula_brdf.h"
#include "core/export/layer_albedo.h"

namespace gonio::exports {

namespace {

constexpr double gltfDielectricF0 = 0.04, gltfMinAlpha = 1e-4;

// Of specularColour: 25 makes a dielectric of index 1.5 a mirror.
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

}  // namespace gonio::exports
