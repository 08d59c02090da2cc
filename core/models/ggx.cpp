// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/ggx.glsl"
}
namespace ranges {
#include "core/models/ggx.glsl"
}

namespace {

constexpr std::string_view walter =
    "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces, eq. 33-34";
constexpr std::string_view maskingChoices[] = {"separable", "height-correlated"};

enum Index { diffuse, specular, roughness, normalReflectance, masking, fresnelTerm, edgeTint };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(1, "k_s D F G / (4 cos theta_i cos theta_o)", walter),
    roughnessParameter("alpha", "Width of the highlight: the slope scale of the microfacets.",
                       "D = alpha^2 / (pi (sin^2 theta_h + alpha^2 cos^2 theta_h)^2)", walter),
    normalReflectanceParameter(),
    choiceParameter("masking", "Masking", "G",
                    "How shadowing and masking combine: independent, or correlated by height (more accurate).",
                    "separable: G1(i) G1(o); height-correlated: 1 / (1 + Lambda(i) + Lambda(o))",
                    "Heitz 2014, Understanding the Masking-Shadowing Function, eq. 98-99", maskingChoices),
    fresnelParameter(FresnelChoice::dielectric),
    edgeTintParameter(),
};

constexpr ModelSpec ggxSpec = {
    .id = "ggx", .name = "GGX",
    .description = "Microfacets with long tails and Smith masking. Reciprocal; loses a "
                   "little energy at high roughness (single scattering).",
    .formula = "k_d / pi + k_s D F G / (4 cos theta_i cos theta_o)", .reference = walter,
    .parameters = parameters,
    .conservesEnergy = true};
// clang-format on

auto arguments(const ParameterValues& p) {
  const double alpha = p.values[roughness].x, f0 = p.values[normalReflectance].x;
  return std::tuple(p.values[diffuse] / pi, p.values[specular], alpha * alpha, double(chosen(p.values[masking].x)),
                    chosenFresnel(p, fresnelTerm, edgeTint, f0));
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const Fresnel fresnel = chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
  return makeGeometryBrdf(
      bound<glsl::formula_ggx, ranges::formula_ggx>(arguments(p)),
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]) * fresnel(typicalCosine),
                     VisibleNormalDensity{p.values[roughness].x}));
}

std::vector<ModelLobe> parts(const ParameterValues& p) {
  const double alpha = p.values[roughness].x;
  return diffuseAndHighlight(create, p, {alpha, alpha});
}

}  // namespace

const Model& ggx() {
  static const Model model(ggxSpec, {.create = create, .arguments = shaderArguments<arguments>, .lobes = parts});
  return model;
}

}  // namespace gonio::models
