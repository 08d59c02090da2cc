// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>

#include "core/math/fast_functions.h"
#include "core/models/beckmann.h"
#include "core/models/common_parameters.h"
#include "core/models/registry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

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

/// Shadowing and obscuration; at Omega = 0 its limit.
double obscuration(const SurfaceGeometry& g, double inverseTau, double omega) {
  const double thetaH = fastAtan2(std::sqrt(g.sin2H), g.half.z);
  const double thetaD = fastAtan2(glm::length(g.wi - g.wo) / 2, g.cosD);
  const double shadowed = fastExp(-2 * thetaD * inverseTau), sum = omega + thetaH;
  return sum > 0 ? (omega + thetaH * shadowed) / sum : shadowed;
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double m = p.values[roughness].x, inverseM2 = 1 / (m * m);
  const Rgb kd = p.values[diffuse] / pi, kv = p.values[volume] * (2 / pi), ks = p.values[specular] / 4.0;
  const double inverseTau = 1 / p.values[tau].x, onset = p.values[omega].x;
  const Fresnel fresnel = chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
  return makeGeometryBrdf(
      [=](const SurfaceGeometry& g) {
        const double surface = beckmannDistribution(g, inverseM2) * fresnel(g.cosD) *
                               obscuration(g, inverseTau, onset) / (g.cosI * g.cosO);
        return kd + kv / (g.cosI + g.cosO) + ks * surface;
      },
      diffuseMixture(maxChannel(p.values[diffuse] + p.values[volume]),
                     maxChannel(p.values[specular]) * fresnel(typicalCosine),
                     HalfVectorDensity{BeckmannNormals{m, m}}));
}

}  // namespace

const Model& beardMaxwell() {
  static const Model model(beardMaxwellSpec, {.create = create});
  return model;
}

}  // namespace gonio::models
