// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/engine_models.h"

#include <algorithm>

#include "core/export/formula_brdf.h"

namespace gonio::exports {

namespace {

constexpr SurfaceLimit unrealLimits[] = {
    {SurfaceField::baseColour, 0, 1},
    {SurfaceField::metalness, 0, 1},
    {SurfaceField::roughness, 0.03, 1},
    {SurfaceField::specular, 0, 1},
};
constexpr SurfaceLimit unityLimits[] = {
    {SurfaceField::baseColour, 0, 1},
    {SurfaceField::metalness, 0, 1},
    {SurfaceField::roughness, 0.03, 1},
};

struct UnrealFormula {
  SurfaceValues v;

  Rgb operator()(const models::SurfaceGeometry& g) const {
    const double alpha = v.roughness * v.roughness, s = schlickWeight(g.cosD);
    const auto widened = [alpha](double cosine) { return cosine * (1 - alpha) + alpha; };
    const double visibility = 0.5 / (g.cosI * widened(g.cosO) + g.cosO * widened(g.cosI));
    const Rgb f0 = glm::mix(Rgb(0.08 * v.specular), v.baseColour, v.metalness);
    // Below 2 % nothing is a real surface: the edge fades too.
    const Rgb fresnel = glm::mix(f0, Rgb(std::min(1.0, 50 * f0.y)), s);
    return (1 - v.metalness) * v.baseColour / pi + ggxDensity(g.half, alpha, alpha) * visibility * fresnel;
  }
};

struct UnityFormula {
  SurfaceValues v;

  Rgb operator()(const models::SurfaceGeometry& g) const {
    constexpr double dielectricF0 = 0.04, renormalised = 1 / 1.03571;
    const double grazing = 0.5 + 2 * v.roughness * g.cosD * g.cosD;
    const auto scattered = [grazing](double cosine) { return glm::mix(1.0, grazing, schlickWeight(cosine)); };
    const double diffuse = renormalised * scattered(g.cosI) * scattered(g.cosO) / pi;
    const Rgb f0 = glm::mix(Rgb(dielectricF0), v.baseColour, v.metalness);
    return (1 - v.metalness) * diffuse * v.baseColour +
           correlatedGgx(g, GgxAlpha(v.roughness * v.roughness)) * glm::mix(f0, Rgb(1), schlickWeight(g.cosD));
  }
};

}  // namespace

const SurfaceShader& unrealShader() {
  static const SurfaceShader shader{
      unrealLimits, {.specular = 0.5}, [](const SurfaceValues& v) { return makeFormulaBrdf(UnrealFormula{v}); }};
  return shader;
}

const SurfaceShader& unityShader() {
  static const SurfaceShader shader{
      unityLimits, {}, [](const SurfaceValues& v) { return makeFormulaBrdf(UnityFormula{v}); }};
  return shader;
}

}  // namespace gonio::exports
