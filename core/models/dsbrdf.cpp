// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>
#include <string_view>

#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"

namespace gonio::models {

namespace glsl {
#include "core/models/dsbrdf.glsl"
}
namespace ranges {
#include "core/models/dsbrdf.glsl"
}

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
    .formula = formulaText, .reference = nishino, .parameters = parameters, .family = ModelFamily::series,
    // The steep parabola of the exponents stretches the rounding of theta_d.
    .floatError = {.relative = 1e-4}};
// clang-format on

/// The strength over exp(kappa(0)) - 1, and ln kappa and ln gamma as polynomials of t = theta_d / 90 degrees.
auto lobeArguments(const ParameterValues& p, std::size_t first) {
  const auto logarithm = [&](std::size_t i) { return std::log(p.values[first + i].x); };
  const double low = logarithm(1), middle = logarithm(2), high = logarithm(3), gamma = logarithm(4);
  return std::tuple(p.values[first] / std::expm1(p.values[first + 1].x),
                    Rgb(low, 4 * middle - 3 * low - high, 2 * low + 2 * high - 4 * middle),
                    glm::dvec2(gamma, logarithm(5) - gamma));
}

auto arguments(const ParameterValues& p) {
  return std::tuple_cat(std::tuple(p.values[0] / pi), lobeArguments(p, firstLobe), lobeArguments(p, secondLobe));
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const auto highlight = [&](std::size_t first, double logCosH) {
    const auto [strength, logKappa, logGamma] = lobeArguments(p, first);
    return luminance(strength) * glsl::dsbrdfLobe(logCosH, 0, logKappa, logGamma);
  };
  return makeGeometryBrdf(bound<glsl::formula_dsbrdf, ranges::formula_dsbrdf>(arguments(p)),
                          excessSampler(maxChannel(p.values[0]), [&](double thetaH) {
                            const double logCosH = std::log(std::cos(thetaH));
                            return highlight(firstLobe, logCosH) + highlight(secondLobe, logCosH);
                          }));
}

}  // namespace

const Model& dsbrdf() {
  static const Model model(dsbrdfSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
