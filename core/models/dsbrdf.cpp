// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/math/fast_functions.h"
#include "core/models/common_parameters.h"
#include "core/models/excess_sampler.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"

namespace gonio::models {

namespace {

constexpr std::string_view nishino =
    "Nishino 2009, Directional Statistics BRDF Model, eq. 3; Nishino and Lombardi 2011, Directional Statistics-based "
    "Reflectance Model for Isotropic Bidirectional Reflectance Distribution Functions";
constexpr std::string_view formulaText =
    "k_d / pi + sum_r s_r (exp(kappa_r cos^(gamma_r) theta_h) - 1) / (exp(kappa_r(0)) - 1)";
constexpr std::string_view kappaFormula =
    "ln kappa(theta_d): the parabola through its values at 0, 45 and 90 degrees; kappa at most 40";
constexpr std::string_view gammaFormula = "ln gamma(theta_d): linear between its values at 0 and 90 degrees";

constexpr std::size_t firstLobe = 1, secondLobe = 7;
/// Beyond, float does not resolve exp(kappa).
constexpr double highestKappa = 40;

// clang-format off
constexpr ParameterSpec strength(std::string_view id, std::string_view label, std::string_view symbol,
                                 double defaultValue, std::string_view description) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "1/sr",
          .softMin = 0, .softMax = 10, .hardMin = 0, .hardMax = 1e6, .defaultValue = defaultValue,
          .perChannel = true, .linear = true,
          .description = description, .formula = formulaText, .reference = nishino, .role = ParameterRole::peak};
}

constexpr ParameterSpec kappa(std::string_view id, std::string_view label, std::string_view symbol,
                              std::string_view description) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 0.01, .softMax = 12, .hardMin = 1e-4, .hardMax = 40, .defaultValue = 1,
          .scale = ParameterScale::logarithmic,
          .description = description, .formula = kappaFormula, .reference = nishino};
}

constexpr ParameterSpec gamma(std::string_view id, std::string_view label, std::string_view symbol, double defaultValue,
                              std::string_view description) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 1, .softMax = 1e4, .hardMin = 1e-3, .hardMax = 1e6, .defaultValue = defaultValue,
          .scale = ParameterScale::logarithmic,
          .description = description, .formula = gammaFormula, .reference = nishino, .role = ParameterRole::sharpness};
}

constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    strength("strength-1", "Lobe 1 strength", "s_1", 1, "Peak and tint of the first lobe at normal incidence."),
    kappa("kappa-1-0", "Kappa 1 at 0°", "kappa_1(0)",
          "Large values give the first lobe a sharp tip and a wide foot."),
    kappa("kappa-1-45", "Kappa 1 at 45°", "kappa_1(45)",
          "Kappa at a difference angle of 45 degrees; if it is larger than at 0 degrees, the lobe is brighter there."),
    kappa("kappa-1-90", "Kappa 1 at 90°", "kappa_1(90)",
          "Kappa of the first lobe at grazing incidence; controls how much the lobe brightens there."),
    gamma("gamma-1-0", "Sharpness 1 at 0°", "gamma_1(0)", 200, "How narrow the first lobe is at normal incidence."),
    gamma("gamma-1-90", "Sharpness 1 at 90°", "gamma_1(90)", 200, "How narrow the first lobe is at grazing incidence."),
    strength("strength-2", "Lobe 2 strength", "s_2", 0.05, "Peak and tint of the second lobe at normal incidence."),
    kappa("kappa-2-0", "Kappa 2 at 0°", "kappa_2(0)",
          "Large values give the second lobe a sharp tip and a wide foot."),
    kappa("kappa-2-45", "Kappa 2 at 45°", "kappa_2(45)",
          "Kappa at a difference angle of 45 degrees; if it is larger than at 0 degrees, the lobe is brighter there."),
    kappa("kappa-2-90", "Kappa 2 at 90°", "kappa_2(90)",
          "Kappa of the second lobe at grazing incidence; controls how much the lobe brightens there."),
    gamma("gamma-2-0", "Sharpness 2 at 0°", "gamma_2(0)", 5, "How narrow the second lobe is at normal incidence."),
    gamma("gamma-2-90", "Sharpness 2 at 90°", "gamma_2(90)", 5, "How narrow the second lobe is at grazing incidence."),
};

constexpr ModelSpec dsbrdfSpec = {
    .id = "dsbrdf", .name = "Directional statistics (DSBRDF)",
    .description = "Two exponential power lobes about the half vector, with strength and width that change with the "
                   "angle of incidence, over a matte base. Published with three lobes per channel; here the channels "
                   "share the shapes, and each lobe has a strength. Reciprocal; nothing bounds the energy.",
    .formula = formulaText, .reference = nishino, .parameters = parameters, .family = ModelFamily::series};
// clang-format on

/// Logarithms of kappa and gamma as polynomials of t = theta_d / 90 degrees.
class Lobe {
 public:
  Lobe(const ParameterValues& p, std::size_t first) : strength_(p.values[first]) {
    const auto logarithm = [&](std::size_t i) { return std::log(p.values[first + i].x); };
    const double low = logarithm(1), middle = logarithm(2), high = logarithm(3);
    kappa_[0] = low;
    kappa_[1] = 4 * middle - 3 * low - high;
    kappa_[2] = 2 * low + 2 * high - 4 * middle;
    gamma_[0] = logarithm(4);
    gamma_[1] = logarithm(5) - gamma_[0];
    strength_ /= std::expm1(p.values[first + 1].x);
  }
  Rgb operator()(double logCosH, double t) const {
    const double k = std::min(highestKappa, fastExp(kappa_[0] + t * (kappa_[1] + t * kappa_[2])));
    return strength_ * fastExpm1(k * fastExp(fastExp(gamma_[0] + t * gamma_[1]) * logCosH));
  }
  void addShaderParameters(std::vector<glm::vec3>& result) const {
    result.insert(result.end(), {glm::vec3(strength_), {kappa_[0], kappa_[1], kappa_[2]}, {gamma_[0], gamma_[1], 0}});
  }

 private:
  Rgb strength_;
  double kappa_[3], gamma_[2];
};

/// theta_d as a fraction of 90 degrees, by its sine too: acos loses half the digits near 1.
double fractionOf(const SurfaceGeometry& g) { return fastAtan2(glm::length(g.wi - g.wo) / 2, g.cosD) / halfPi; }

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const Rgb kd = p.values[0] / pi;
  const Lobe first(p, firstLobe), second(p, secondLobe);
  const auto lobes = [=](double logCosH, double t) { return first(logCosH, t) + second(logCosH, t); };
  return makeGeometryBrdf(
      [=](const SurfaceGeometry& g) { return kd + lobes(fastLog1p(-g.oneMinusCosH), fractionOf(g)); },
      excessSampler(maxChannel(p.values[0]),
                    [&](double thetaH) { return luminance(lobes(std::log(std::cos(thetaH)), 0)); }));
}

/// The lobes with their polynomials and normalisation.
std::vector<glm::vec3> shaderParameters(const ParameterValues& p) {
  std::vector<glm::vec3> result{glm::vec3(p.values[0])};
  Lobe(p, firstLobe).addShaderParameters(result);
  Lobe(p, secondLobe).addShaderParameters(result);
  return result;
}

}  // namespace

const Model& dsbrdf() {
  static const Model model(dsbrdfSpec, {.create = create, .shaderParameters = shaderParameters});
  return model;
}

}  // namespace gonio::models
