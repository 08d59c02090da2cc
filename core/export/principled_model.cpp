// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/principled_model.h"

#include <algorithm>
#include <cmath>

#include "core/export/formula_brdf.h"
#include "core/models/fresnel.h"

namespace gonio::exports {

namespace {

// Cycles leaves out a lobe of alpha^2 below 1e-7.
constexpr SurfaceLimit principledLimits[] = {
    {SurfaceField::baseColour, 0, 1},   {SurfaceField::metalness, 0, 1}, {SurfaceField::roughness, 0.03, 1},
    {SurfaceField::anisotropy, 0, 1},   {SurfaceField::rotation, -7, 7}, {SurfaceField::specular, 0, 1},
    {SurfaceField::specularTint, 0, 1}, {SurfaceField::coat, 0, 1},      {SurfaceField::coatRoughness, 0.03, 1},
};

struct PrincipledFormula {
  SurfaceValues v;
  GgxAlpha alpha;
  Rgb f0;
  double ior;  ///< of the Fresnel term's rise

  explicit PrincipledFormula(const SurfaceValues& values) : v(values), alpha(1) {
    const double aspect = std::sqrt(1 - 0.9 * v.anisotropy), squared = v.roughness * v.roughness;
    alpha = GgxAlpha(squared / aspect, squared * aspect);
    const double grey = 0.3 * v.baseColour.x + 0.6 * v.baseColour.y + 0.1 * v.baseColour.z;
    const Rgb hue = grey > 0 ? v.baseColour / grey : Rgb(1);
    f0 = glm::mix(0.08 * v.specular * glm::mix(Rgb(1), hue, v.specularTint), v.baseColour, v.metalness);
    ior = 2 / (1 - std::sqrt(0.08 * v.specular)) - 1;
  }

  Rgb operator()(const models::SurfaceGeometry& g) const {
    const double rise = riseOf(g.cosD, ior);
    Rgb value = (1 - v.metalness) * diffuse(g) * v.baseColour;
    value += separableGgx(g, alpha) * glm::mix(f0, Rgb(1), rise);
    return v.coat > 0 ? value + coat(g) : value;
  }

 private:
  /// 0 at normal incidence, 1 at grazing incidence.
  static double riseOf(double cosD, double index) {
    const double least = models::normalReflectanceFromIndex(index);
    return std::max(0.0, models::fresnelDielectric(cosD, index) - least) / (1 - least);
  }

  double diffuse(const models::SurfaceGeometry& g) const {
    const double i = schlickWeight(g.cosI), o = schlickWeight(g.cosO), r = 2 * v.roughness * g.cosD * g.cosD;
    return ((1 - 0.5 * i) * (1 - 0.5 * o) + r * (i + o + i * o * (r - 1))) / pi;
  }

  Rgb coat(const models::SurfaceGeometry& g) const {
    constexpr double maskingAlpha = 0.25, strength = 0.25;
    const double squared = std::pow(v.coatRoughness, 4);
    const double density =
        squared < 1 ? (squared - 1) / (pi * std::log(squared) * (g.sin2H + squared * g.half.z * g.half.z)) : 1 / pi;
    const double masking =
        0.25 / (ggxCosineOverG1(g.wi, maskingAlpha, maskingAlpha) * ggxCosineOverG1(g.wo, maskingAlpha, maskingAlpha));
    return Rgb(strength * v.coat * density * masking * glm::mix(0.04, 1.0, riseOf(g.cosD, 1.5)));
  }
};

}  // namespace

const SurfaceShader& principledShader() {
  static const SurfaceShader shader{
      principledLimits, {.specular = 0.5, .coatRoughness = 0.03}, [](const SurfaceValues& v) {
        return makeFormulaBrdf(PrincipledFormula(v), {.isotropic = !(v.anisotropy > 0), .rotation = v.rotation});
      }};
  return shader;
}

}  // namespace gonio::exports
