// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/direction_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/neumann_distance.glsl"
}
namespace ranges {
#include "core/models/neumann_distance.glsl"
}

namespace {

constexpr std::string_view neumann1996 =
    "Neumann and Neumann 1996, New Simple Reflectance Models for Metals and Other Specular Materials "
    "(falloffs and normalisation derived here)";
constexpr std::string_view falloffs[] = {"gaussian", "rational"};

enum Index { diffuse, specular, width, falloff, power };
enum Falloff { gaussian, rational };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1, "k_s f(|Dp|), |Dp| = |i_xy + o_xy| the distance from the mirror point", neumann1996),
    {.id = "width", .label = "Width", .symbol = "s", .unit = "",
     .softMin = 0.01, .softMax = 1, .hardMin = 1e-4, .hardMax = 10, .defaultValue = 0.2,
     .scale = ParameterScale::logarithmic,
     .description = "Width of the highlight on the disk of projected directions: small values are glossy.",
     .formula = "|Dp| / s", .reference = neumann1996, .role = ParameterRole::width},
    choiceParameter("falloff", "Falloff", "f", "Falloff of the highlight: a Gaussian, or a long tail.",
                    "gaussian: exp(-|Dp|^2 / s^2) / (pi s^2); rational: (C - 1) / (pi s^2) (1 + |Dp|^2 / s^2)^-C",
                    neumann1996, falloffs),
    {.id = "power", .label = "Tail power", .symbol = "C", .unit = "",
     .softMin = 1.05, .softMax = 8, .hardMin = 1.001, .hardMax = 100, .defaultValue = 2,
     .scale = ParameterScale::logarithmic,
     .description = "How fast the tail of the highlight falls: near 1 it covers the whole hemisphere.",
     .formula = "(1 + |Dp|^2 / s^2)^-C", .reference = neumann1996,
     .activeWith = "falloff", .activeChoice = 1},
};

constexpr ModelSpec neumannDistanceSpec = {
    .id = "neumann-distance", .name = "Neumann distance",
    .description = "A highlight that depends only on how far the projected light lies from the mirror point of "
                   "the viewer. Reciprocal; the albedo is an integral over the unit disk, so it is bounded by "
                   "the integral over the plane, which is k_s.",
    .formula = "k_d / pi + k_s f(|i_xy + o_xy|)",
    .reference = neumann1996, .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

auto arguments(const ParameterValues& p) {
  const double s2 = p.values[width].x * p.values[width].x, c = p.values[power].x;
  const bool isRational = chosen(p.values[falloff].x) == rational;
  return std::tuple(p.values[diffuse] / pi, p.values[specular] * ((isRational ? c - 1 : 1) / (pi * s2)), 1 / s2, c,
                    isRational ? 1.0 : 0.0);
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const auto [kd, ks, sharpness, c, isRational] = arguments(p);
  const double diffuseAlbedo = maxChannel(p.values[diffuse]), albedo = maxChannel(p.values[specular]);
  if (isRational == 0)
    return makeGeometryBrdf(bound<glsl::gaussianFalloff, ranges::gaussianFalloff>(std::tuple(kd, ks, sharpness)),
                            diffuseMixture(diffuseAlbedo, albedo, DiskDensity{GaussianRadial{p.values[width].x}}));
  return makeGeometryBrdf(bound<glsl::rationalFalloff, ranges::rationalFalloff>(std::tuple(kd, ks, sharpness, c)),
                          diffuseMixture(diffuseAlbedo, albedo, DiskDensity{RationalRadial{sharpness, c}}));
}

}  // namespace

const Model& neumannDistance() {
  static const Model model(neumannDistanceSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
