// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <array>

#include "core/models/anisotropic_parameters.h"
#include "core/models/common_parameters.h"
#include "core/models/fresnel.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

/// Microfacets with a width along the grain and another across it, under Smith's masking: of GGX and of Beckmann.
namespace gonio::models {

namespace {

constexpr std::string_view heitz = "Heitz 2014, Understanding the Masking-Shadowing Function";
constexpr std::string_view maskingChoices[] = {"separable", "height-correlated"};

enum Index { diffuse, specular, roughnessX, roughnessY, rotation, normalReflectance, masking, fresnelTerm, edgeTint };

// clang-format off
constexpr std::string_view formula = "k_d / pi + k_s D F G / (4 cos theta_i cos theta_o)";
constexpr std::string_view ggxDistribution =
    "D = 1 / (pi alpha_x alpha_y (h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2 + h_z^2)^2)";
constexpr std::string_view beckmannDistribution =
    "D = exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / (pi alpha_x alpha_y h_z^4)";

constexpr std::array<ParameterSpec, 9> parametersOf(std::string_view distribution) {
  return {diffuseParameter(0.2),
          specularParameter(1, "k_s D F G / (4 cos theta_i cos theta_o)", heitz),
          roughnessXParameter(distribution, heitz),
          roughnessYParameter(distribution, heitz),
          rotationParameter(),
          normalReflectanceParameter(),
          choiceParameter("masking", "Masking", "G",
                          "How shadowing and masking combine: independent, or correlated by height (more accurate).",
                          "separable: G1(i) G1(o); height-correlated: 1 / (1 + Lambda(i) + Lambda(o))",
                          "Heitz 2014, Understanding the Masking-Shadowing Function, eq. 98-99", maskingChoices),
          fresnelParameter(FresnelChoice::dielectric),
          edgeTintParameter()};
}
constexpr auto ggxParameters = parametersOf(ggxDistribution), beckmannParameters = parametersOf(beckmannDistribution);

constexpr ModelSpec ggxSpec = {
    .id = "ggx-anisotropic", .name = "GGX, anisotropic",
    .description = "Microfacets with long tails and separate widths along x and y: brushed and rolled metal. "
                   "Reciprocal; loses a little energy at high roughness (single scattering).",
    .formula = formula,
    .reference = "Heitz 2014, Understanding the Masking-Shadowing Function, section 5; Walter et "
                 "al. 2007, Microfacet Models for Refraction through Rough Surfaces",
    .parameters = ggxParameters, .conservesEnergy = true};

constexpr ModelSpec beckmannSpec = {
    .id = "beckmann-anisotropic", .name = "Beckmann, anisotropic",
    .description = "Microfacets with Gaussian slopes, separate widths along x and y, and Smith masking. "
                   "Reciprocal; loses a little energy at high roughness (single scattering).",
    .formula = formula,
    .reference = "Heitz 2014, Understanding the Masking-Shadowing Function, section 5; Beckmann "
                 "and Spizzichino 1963, The Scattering of Electromagnetic Waves from Rough Surfaces",
    .parameters = beckmannParameters, .conservesEnergy = true};
// clang-format on

/// A distribution, cos theta (1 + Lambda) of its masking, and its sampler.
struct Ggx {
  static double density(const Direction& h, double x, double y) { return ggxDensity(h, x, y); }
  static double shadowedCosine(const Direction& w, double x, double y) { return ggxCosineOverG1(w, x, y); }
  using Lobe = VisibleNormalDensity;
};
struct Beckmann {
  static double density(const Direction& h, double x, double y) { return beckmannDensity(h, x, y); }
  static double shadowedCosine(const Direction& w, double x, double y) { return beckmannCosineOverG1(w, x, y); }
  using Lobe = BeckmannVisibleDensity;
};

template <typename Facets>
std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular] / 4.0;
  const double alphaX = p.values[roughnessX].x, alphaY = p.values[roughnessY].x, angle = p.values[rotation].x;
  const Fresnel fresnel = chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
  const double heightCorrelated = chosen(p.values[masking].x);
  return makeGeometryBrdf(
      [=, toGrain = AzimuthRotation(-angle)](const SurfaceGeometry& g) {
        const double shadowedI = Facets::shadowedCosine(toGrain(g.wi), alphaX, alphaY);
        const double shadowedO = Facets::shadowedCosine(toGrain(g.wo), alphaX, alphaY);
        // cos theta_i cos theta_o / G, so that nothing is divided by a cosine.
        const double ofBoth = g.cosO * shadowedI + g.cosI * shadowedO - g.cosI * g.cosO;
        const double cosines = heightCorrelated * ofBoth + (1 - heightCorrelated) * (shadowedI * shadowedO);
        return kd + ks * (Facets::density(toGrain(g.half), alphaX, alphaY) * fresnel(g.cosD) / cosines);
      },
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]) * fresnel(typicalCosine),
                     RotatedDensity(typename Facets::Lobe{alphaX, alphaY}, angle)),
      alphaX == alphaY);
}

std::vector<glm::vec3> shaderParameters(const ParameterValues& p) { return withGrainAxis(p, rotation); }

ParameterValues canonical(const ParameterValues& p) { return alongGrain(p, {roughnessX, roughnessY, rotation}, true); }

template <typename Facets>
std::vector<ModelLobe> parts(const ParameterValues& p) {
  return diffuseAndHighlight(create<Facets>, p, {p.values[roughnessX].x, p.values[roughnessY].x, p.values[rotation].x});
}

template <typename Facets>
constexpr Model::Functions functions{
    .create = create<Facets>, .shaderParameters = shaderParameters, .lobes = parts<Facets>, .canonical = canonical};

}  // namespace

const Model& ggxAnisotropic() {
  static const Model model(ggxSpec, functions<Ggx>);
  return model;
}

const Model& beckmannAnisotropic() {
  static const Model model(beckmannSpec, functions<Beckmann>);
  return model;
}

}  // namespace gonio::models
