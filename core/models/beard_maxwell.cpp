// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/beard_maxwell.glsl"
}
namespace ranges {
#include "core/models/beard_maxwell.glsl"
}

namespace {

constexpr std::string_view westlundMeyer =
    "Maxwell, Beard, Weiner, Ladd and Ladd 1973, Bidirectional Reflectance Model Validation and Utilization; Westlund "
    "and Meyer 2002, A BRDF Database Employing the Beard-Maxwell Reflection Model";
constexpr std::string_view obscurationFormula =
    "SO = (1 + (theta_h / Omega) exp(-2 theta_d / tau)) / (1 + theta_h / Omega)";

enum Index { diffuse, volume, specular, roughness, normalReflectance, tau, omega, fresnelTerm, edgeTint };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.1),
    {.id = "volume", .label = "Volume", .symbol = "k_v", .unit = "",
     .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 10, .defaultValue = 0.1,
     .group = ParameterGroup::diffuse, .perChannel = true, .linear = true,
     .description = "Light scattered once below the surface: brighter towards grazing angles than the diffuse term.",
     .formula = "2 k_v / (pi (cos theta_i + cos theta_o))", .reference = westlundMeyer,
     .role = ParameterRole::diffuse},
    specularParameter(1, "k_s D F SO / (4 cos theta_i cos theta_o)", westlundMeyer),
    roughnessParameter("m", "Width of the highlight: the root mean square slope of the microfacets.",
                       "D = exp(-tan^2 theta_h / m^2) / (pi m^2 cos^4 theta_h)", westlundMeyer),
    normalReflectanceParameter(),
    {.id = "tau", .label = "Shadowing falloff", .symbol = "tau", .unit = "rad",
     .softMin = 0.05, .softMax = 3, .hardMin = 1e-3, .hardMax = 100, .defaultValue = 1,
     .scale = ParameterScale::angle, .group = ParameterGroup::shadowing,
     .description = "Angle between light and viewer at which the shadows of the facets have 63 % of their full strength; large values "
                    "remove the shadows.",
     .formula = obscurationFormula, .reference = westlundMeyer},
    {.id = "omega", .label = "Shadowing onset", .symbol = "Omega", .unit = "rad",
     .softMin = 0, .softMax = halfPi, .hardMin = 0, .hardMax = 100, .defaultValue = 0.5,
     .scale = ParameterScale::angle, .group = ParameterGroup::shadowing,
     .description = "Tilt above which facets shadow each other; at 0 all do.",
     .formula = obscurationFormula, .reference = westlundMeyer},
    fresnelParameter(FresnelChoice::dielectric),
    edgeTintParameter(),
};

constexpr ModelSpec beardMaxwellSpec = {
    .id = "beard-maxwell", .name = "Beard-Maxwell",
    .description = "Painted surfaces: facets that reflect and shadow each other, over a volume that scatters. The "
                   "measured facet distribution of the original is replaced by a Beckmann lobe. Reciprocal; the "
                   "energy is not bounded at grazing angles, neither in the volume term nor in the shadowed highlight.",
    .formula = "k_d / pi + 2 k_v / (pi (cos theta_i + cos theta_o)) + k_s D F SO / (4 cos theta_i cos theta_o)",
    .reference = westlundMeyer, .parameters = parameters};
// clang-format on

Fresnel fresnelOf(const ParameterValues& p) {
  return chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
}

auto arguments(const ParameterValues& p) {
  const double m = p.values[roughness].x;
  return std::tuple(p.values[diffuse] / pi, p.values[volume] * (2 / pi), p.values[specular] / 4.0, 1 / (m * m),
                    1 / p.values[tau].x, p.values[omega].x, fresnelOf(p));
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double m = p.values[roughness].x;
  return makeGeometryBrdf(bound<glsl::formula_beard_maxwell, ranges::formula_beard_maxwell>(arguments(p)),
                          diffuseMixture(maxChannel(p.values[diffuse] + p.values[volume]),
                                         maxChannel(p.values[specular]) * fresnelOf(p)(typicalCosine),
                                         HalfVectorDensity{BeckmannNormals{m, m}}));
}

}  // namespace

const Model& beardMaxwell() {
  static const Model model(beardMaxwellSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
