// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/cook_torrance.glsl"
}
namespace ranges {
#include "core/models/cook_torrance.glsl"
}

namespace {

constexpr std::string_view cookTorrance1982 = "Cook and Torrance 1982, A Reflectance Model for Computer Graphics";
constexpr std::string_view normalisations[] = {"walter", "ngan", "original-1982"};

enum Index { diffuse, specular, roughness, normalReflectance, normalisation, fresnelTerm, edgeTint };

// clang-format off
// Published fits of the roughness reach 2.1 (Löw et al. 2012).
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(1, "k_s D F G / (N cos theta_i cos theta_o)", cookTorrance1982),
    roughnessParameter("m", "Width of the highlight: the root mean square slope of the microfacets.",
                       "D = exp(-tan^2 theta_h / m^2) / (pi m^2 cos^4 theta_h)", cookTorrance1982, 5),
    normalReflectanceParameter(),
    choiceParameter("normalisation", "Normalisation", "N",
                    "Constant N in the denominator of the highlight, which differs between publications: for published "
                    "parameters, choose the constant of their publication.",
                    "walter: 4 (conserves energy); ngan: pi; original-1982: 1 (the paper has N = pi and a D without "
                    "the factor 1/pi, which is equivalent)",
                    "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces, eq. 20; Ngan et al. 2005, Experimental Analysis of BRDF Models; Cook and "
                    "Torrance 1982", normalisations),
    fresnelParameter(FresnelChoice::dielectric),
    edgeTintParameter(),
};

constexpr ModelSpec cookTorranceSpec = {
    .id = "cook-torrance", .name = "Cook-Torrance",
    .description = "Beckmann microfacets with V-cavity masking. Reciprocal; conserves energy with "
                   "normalisation 'walter'; the energy is too high by a factor of up to 4/pi with 'ngan' and up to 4 "
                   "with 'original-1982'.",
    .formula = "k_d / pi + k_s D F G / (N cos theta_i cos theta_o)", .reference = cookTorrance1982,
    .parameters = parameters, .conservesEnergy = true};
// clang-format on

/// N of the parameter's choices, for a D that holds 1/pi.
constexpr double denominators[] = {4, pi, 1};

Fresnel fresnelOf(const ParameterValues& p) {
  return chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
}

auto arguments(const ParameterValues& p) {
  const double m = p.values[roughness].x, denominator = denominators[chosen(p.values[normalisation].x)];
  return std::tuple(p.values[diffuse] / pi, p.values[specular] / denominator, 1 / (m * m), fresnelOf(p));
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double m = p.values[roughness].x;
  return makeGeometryBrdf(
      bound<glsl::formula_cook_torrance, ranges::formula_cook_torrance>(arguments(p)),
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]) * fresnelOf(p)(typicalCosine),
                     HalfVectorDensity{BeckmannNormals{m, m}}));
}

}  // namespace

const Model& cookTorrance() {
  static const Model model(cookTorranceSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
