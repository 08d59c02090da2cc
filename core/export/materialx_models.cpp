// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/materialx_models.h"

#include <algorithm>
#include <cmath>

#include "core/export/layer_albedo.h"
#include "core/models/fresnel.h"

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

}  // namespace gonio::exports
