// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <array>
#include <glm/exponential.hpp>

#include "core/models/common_parameters.h"
#include "core/models/registry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/weidlich_wilkie.glsl"
}

namespace {

constexpr std::string_view weidlichWilkie2007 = "Weidlich and Wilkie 2007, Arbitrarily Layered Micro-Facet Surfaces";
constexpr std::string_view layersFormula =
    "f_1(i, o) + T a t f_2(i', o'), T = 1 - F_1, t = (1 - G) + T G, f_1 = k_c D_1 F_1 G / (4 cos theta_i cos theta_o), "
    "f_2 = k_d / pi + k_s D_2 F_2 G' / (4 cos theta_i' cos theta_o')";
constexpr std::string_view beckmannFormula = "D = exp(-tan^2 theta_h / m^2) / (pi m^2 cos^4 theta_h)";

enum Index {
  diffuse,
  specular,
  roughness,
  normalReflectance,
  coat,
  coatRoughness,
  coatIndex,
  absorption,
  fresnelTerm,
  edgeTint
};

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.5, "k_s D_2 F_2 G' / (4 cos theta_i' cos theta_o'), i' and o' refracted at h",
                      weidlichWilkie2007),
    roughnessParameter("m_2", "Width of the highlight of the base under the coat.", beckmannFormula,
                       weidlichWilkie2007, 5),
    normalReflectanceParameter(0.6),
    {.id = "coat", .label = "Coat", .symbol = "k_c", .unit = "",
     .softMin = 0, .softMax = 2, .hardMin = 0, .hardMax = 100, .defaultValue = 1,
     .group = ParameterGroup::layer, .perChannel = true, .linear = true,
     .description = "Strength and tint of the highlight on the coat; a real coat has 1.",
     .formula = "k_c D_1 F_1 G / (4 cos theta_i cos theta_o)", .reference = weidlichWilkie2007,
     .role = ParameterRole::coat},
    {.id = "coat-roughness", .label = "Coat roughness", .symbol = "m_1", .unit = "",
     .softMin = 0.005, .softMax = 1, .hardMin = 1e-4, .hardMax = 5, .defaultValue = 0.05,
     .scale = ParameterScale::logarithmic, .group = ParameterGroup::layer,
     .description = "Width of the highlight on the coat.", .formula = beckmannFormula,
     .reference = weidlichWilkie2007, .role = ParameterRole::width},
    {.id = "coat-index", .label = "Coat index of refraction", .symbol = "eta", .unit = "",
     .softMin = 1, .softMax = 2.5, .hardMin = 1, .hardMax = 1000, .defaultValue = 1.5,
     .group = ParameterGroup::layer,
     .description = "Index of refraction of the coat: sets how much it refracts and reflects; 1 is no coat.",
     .formula = "sin theta_d' = sin theta_d / eta, F_1 exact dielectric", .reference = weidlichWilkie2007},
    {.id = "absorption", .label = "Absorption", .symbol = "sigma d", .unit = "",
     .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 100, .defaultValue = 0.1,
     .group = ParameterGroup::layer, .perChannel = true,
     .description = "Optical depth of the coat: deepens the colour of the base, especially towards grazing angles.",
     .formula = "a = exp(-sigma d (1 / cos theta_i' + 1 / cos theta_o'))",
     .reference = "Bouguer 1729, Lambert 1760, Beer 1852; Weidlich and Wilkie 2007"},
    fresnelParameter(FresnelChoice::conductor),
    edgeTintParameter(),
};

constexpr ModelSpec weidlichWilkieSpec = {
    .id = "weidlich-wilkie", .name = "Weidlich-Wilkie",
    .description = "A rough clear coat that absorbs, over a base with a matte and a glossy part. Reciprocal. Omits "
                   "interreflection between the layers; a white matte base gains energy at grazing angles (albedo "
                   "1.16 at 75 degrees).",
    .formula = layersFormula, .reference = weidlichWilkie2007, .parameters = parameters};
// clang-format on

Fresnel baseFresnel(const ParameterValues& p) {
  return chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
}

auto arguments(const ParameterValues& p) {
  const double m1 = p.values[coatRoughness].x, m2 = p.values[roughness].x, eta = p.values[coatIndex].x;
  const Fresnel coatFresnel(FresnelChoice::dielectric, normalReflectanceFromIndex(eta), 0);
  return std::tuple(p.values[diffuse] / pi, p.values[specular] / 4.0, 1 / (m2 * m2), baseFresnel(p),
                    p.values[coat] / 4.0, 1 / (m1 * m1), coatFresnel, eta, p.values[absorption]);
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double m1 = p.values[coatRoughness].x, m2 = p.values[roughness].x;
  const double entering = fresnelTransmittance(typicalCosine, p.values[coatIndex].x);
  const double kept = entering * entering * maxChannel(glm::exp(-2.0 * p.values[absorption]));
  return makeGeometryBrdf(
      bound<glsl::formula_weidlich_wilkie>(arguments(p)),
      DensityMixture(
          mixtureFractions(std::array{maxChannel(p.values[diffuse]) * kept, maxChannel(p.values[coat]) * (1 - entering),
                                      maxChannel(p.values[specular]) * kept * baseFresnel(p)(typicalCosine)}),
          CosineDensity{}, HalfVectorDensity{BeckmannNormals{m1, m1}}, HalfVectorDensity{BeckmannNormals{m2, m2}}));
}

}  // namespace

const Model& weidlichWilkie() {
  static const Model model(weidlichWilkieSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
