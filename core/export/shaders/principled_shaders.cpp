// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/export/shaders/shading_formulas.h"
#include "core/export/shaders/shading_models.h"
#include "core/math/parallel.h"
#include "core/models/fresnel.h"

namespace gonio::exports {

namespace {

// Cycles leaves out a lobe of alpha^2 below 1e-7.
constexpr SurfaceLimit principled3Limits[] = {
    {SurfaceField::baseColour, 0, 1},   {SurfaceField::metalness, 0, 1}, {SurfaceField::roughness, 0.03, 1},
    {SurfaceField::anisotropy, 0, 1},   {SurfaceField::rotation, -7, 7}, {SurfaceField::specular, 0, 1},
    {SurfaceField::specularTint, 0, 1}, {SurfaceField::coat, 0, 1},      {SurfaceField::coatRoughness, 0.03, 1},
};
constexpr SurfaceLimit principled4Limits[] = {
    {SurfaceField::baseColour, 0, 1},     {SurfaceField::metalness, 0, 1}, {SurfaceField::roughness, 0.03, 1},
    {SurfaceField::anisotropy, 0, 1},     {SurfaceField::rotation, -7, 7}, {SurfaceField::specular, 0, 1},
    {SurfaceField::specularColour, 0, 1}, {SurfaceField::coat, 0, 1},      {SurfaceField::coatRoughness, 0.03, 1},
};

/// The widths along and across the grain in both series.
GgxAlpha principledAlpha(const SurfaceValues& v) {
  const double aspect = std::sqrt(1 - 0.9 * v.anisotropy), squared = v.roughness * v.roughness;
  return {squared / aspect, squared * aspect};
}

/// Reflectance at normal incidence of the dielectric: 0.04 for the default level of 0.5 and the index 1.5.
double principledF0(const SurfaceValues& v) { return 0.08 * v.specular; }

/// The index of refraction with a reflectance at normal incidence, in [0, 1).
double indexOf(double f0) { return 2 / (1 - std::sqrt(f0)) - 1; }

/// The exact dielectric formula's rise: 0 at normal incidence, 1 at grazing incidence.
double dielectricRise(double cosD, double index) {
  const double least = models::normalReflectanceFromIndex(index);
  return std::max(0.0, models::fresnelDielectric(cosD, index) - least) / (1 - least);
}

struct Principled3Formula {
  SurfaceValues v;
  GgxAlpha alpha;
  Rgb f0;
  double ior;  ///< of the Fresnel term's rise

  explicit Principled3Formula(const SurfaceValues& values)
      : v(values), alpha(principledAlpha(v)), ior(indexOf(principledF0(v))) {
    const double grey = 0.3 * v.baseColour.x + 0.6 * v.baseColour.y + 0.1 * v.baseColour.z;
    const Rgb hue = grey > 0 ? v.baseColour / grey : Rgb(1);
    f0 = glm::mix(principledF0(v) * glm::mix(Rgb(1), hue, v.specularTint), v.baseColour, v.metalness);
  }

  Rgb operator()(const models::SurfaceGeometry& g) const {
    Rgb value = (1 - v.metalness) * diffuse(g) * v.baseColour;
    value += separableGgx(g, alpha) * glm::mix(f0, Rgb(1), dielectricRise(g.cosD, ior));
    return v.coat > 0 ? value + coat(g) : value;
  }

 private:
  double diffuse(const models::SurfaceGeometry& g) const {
    const double i = schlickWeight(g.cosI), o = schlickWeight(g.cosO), r = 2 * v.roughness * g.cosD * g.cosD;
    return ((1 - 0.5 * i) * (1 - 0.5 * o) + r * (i + o + i * o * (r - 1))) / pi;
  }

  Rgb coat(const models::SurfaceGeometry& g) const {
    constexpr double maskingAlpha = 0.25, strength = 0.25;
    const double squared = std::pow(v.coatRoughness, 4);
    const double density =
        squared < 1 ? (squared - 1) / (pi * std::log(squared) * (g.sin2H + squared * g.h.z * g.h.z)) : 1 / pi;
    const double masking =
        0.25 / (ggxCosineOverG1(g.wi, maskingAlpha, maskingAlpha) * ggxCosineOverG1(g.wo, maskingAlpha, maskingAlpha));
    return Rgb(strength * v.coat * density * masking * glm::mix(0.04, 1.0, dielectricRise(g.cosD, 1.5)));
  }
};

/// The mean of dielectricRise() over the light that a GGX lobe reflects to the viewer, by roughness, cosine of the
/// viewer and the fourth root of the reflectance at normal incidence: Cycles reads the same integral from a table of
/// this many nodes, linearly.
class MeanRise {
 public:
  MeanRise() : values_(nodes * nodes * nodes) {
    parallelForBlocks(nodes, 1, [&](std::size_t width, std::size_t) {
      for (std::size_t k = 0; k < nodes * nodes; ++k)
        values_[width * nodes * nodes + k] = integrate(at(width), at(k / nodes), at(k % nodes));
    });
  }

  double operator()(double roughness, double cosine, double f0) const {
    const Place x = place(roughness), y = place(cosine), z = place(std::sqrt(std::sqrt(f0)));
    double sum = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
      const auto part = [](const Place& on, std::size_t next) { return next ? on.fraction : 1 - on.fraction; };
      sum += part(x, i) * part(y, j) * part(z, k) * values_[((x.node + i) * nodes + y.node + j) * nodes + z.node + k];
    }
    return sum;
  }

 private:
  static constexpr std::size_t nodes = 16;

  struct Place {
    std::size_t node;
    double fraction;
  };
  static Place place(double value) {
    const double at = std::clamp(value, 0.0, 1.0) * double(nodes - 1);
    const std::size_t node = std::min(std::size_t(at), nodes - 2);
    return {node, at - double(node)};
  }
  static double at(std::size_t node) { return std::clamp(double(node) / double(nodes - 1), 1e-3, 0.999); }

  static double integrate(double roughness, double cosine, double root) {
    constexpr int strata = 16;
    const double alpha = roughness * roughness, index = indexOf(std::pow(root, 4));
    const Direction wo(std::sqrt(1 - cosine * cosine), 0, cosine);
    const VisibleNormalDensity lobe(alpha);
    double sum = 0, light = 0;
    for (int i = 0; i < strata * strata; ++i) {
      const Direction wi = lobe.sample(wo, {(i % strata + 0.5) / strata, (i / strata + 0.5) / strata});
      if (!models::isAboveSurface({wi, wo})) continue;
      const models::SurfaceGeometry g = models::surfaceGeometry({wi, wo});
      const double weight = correlatedGgx(g, GgxAlpha(alpha)) * wi.z / lobe.density(wi, wo);
      light += weight;
      sum += weight * dielectricRise(g.cosD, index);
    }
    return light > 0 ? sum / light : dielectricRise(cosine, index);
  }

  std::vector<double> values_;
};

double meanRise(double roughness, double cosine, double f0) {
  static const MeanRise table;
  return table(roughness, cosine, f0);
}

struct Principled4Formula {
  static constexpr double coatIndex = 1.5;

  SurfaceValues v;
  GgxAlpha alpha, coatAlpha;
  double f0, ior;

  explicit Principled4Formula(const SurfaceValues& values)
      : v(values),
        alpha(principledAlpha(v)),
        coatAlpha(v.coatRoughness * v.coatRoughness),
        f0(principledF0(v)),
        ior(indexOf(f0)) {}

  Rgb operator()(const models::SurfaceGeometry& g) const {
    const double lobe = correlatedGgx(g, alpha);
    Rgb value =
        v.metalness * lobe * glm::clamp(tintedSchlick(g.cosD, v.baseColour, Rgb(1), v.specularColour), 0.0, 1.0);
    if (v.metalness < 1) value += (1 - v.metalness) * dielectric(g, lobe);
    if (!(v.coat > 0)) return value;
    const double below = 1 - v.coat * models::fresnelDielectric(g.cosO, coatIndex);
    return below * value + Rgb(v.coat * correlatedGgx(g, coatAlpha) * models::fresnelDielectric(g.cosD, coatIndex));
  }

 private:
  Rgb dielectric(const models::SurfaceGeometry& g, double lobe) const {
    const auto reflectance = [&](double rise) { return glm::mix(f0 * v.specularColour, Rgb(1), rise); };
    const double albedo = maxChannel(reflectance(meanRise(v.roughness, g.cosO, f0)));
    return lobe * reflectance(dielectricRise(g.cosD, ior)) + (1 - albedo) / pi * v.baseColour;
  }
};

FormulaTraits principledTraits(const SurfaceValues& v, bool reciprocal) {
  return {.isotropic = !(v.anisotropy > 0), .reciprocal = reciprocal, .rotation = v.rotation};
}

}  // namespace

const SurfaceShader& principledShader(BlenderVersion blender) {
  static const SurfaceShader three{
      principled3Limits, {.specular = 0.5, .coatRoughness = 0.03}, [](const SurfaceValues& v) {
        return makeFormulaBrdf(Principled3Formula(v), principledTraits(v, true));
      }};
  static const SurfaceShader four{
      principled4Limits, {.specular = 0.5, .coatRoughness = 0.03}, [](const SurfaceValues& v) {
        return makeFormulaBrdf(Principled4Formula(v), principledTraits(v, false));
      }};
  return blender == BlenderVersion::v3 ? three : four;
}

}  // namespace gonio::exports
