// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <array>

#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/car_paint.glsl"
}
namespace ranges {
#include "core/models/car_paint.glsl"
}

namespace {

constexpr std::string_view guenther =
    "Günther, Chen, Goesele, Wald and Seidel 2005, Efficient Acquisition and Realistic Rendering of Car Paint; Rump, "
    "Müller, Sarlette, Koch and Klein 2008, Photo-realistic Rendering of Metallic Car Paint from Image-Based "
    "Measurements";
constexpr std::string_view lobeFormula = "k D F G / (N cos theta_i cos theta_o)";
constexpr std::string_view normalisations[] = {"walter", "rump"};

constexpr int lobes = 3;
/// After the diffuse part three parameters a lobe: strength, roughness, reflectance.
enum Index { diffuse, firstLobe, normalisation = firstLobe + 3 * lobes, fresnelTerm, edgeTint };

// clang-format off
constexpr ParameterSpec strengthParameter(std::string_view id, std::string_view label, std::string_view symbol,
                                          double defaultValue, ParameterRole role, std::string_view description) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 0, .softMax = 2, .hardMin = 0, .hardMax = 100, .defaultValue = defaultValue,
          .perChannel = true, .linear = true, .description = description, .formula = lobeFormula,
          .reference = guenther, .role = role};
}

constexpr ParameterSpec widthParameter(std::string_view id, std::string_view label, std::string_view symbol,
                                       double defaultValue, std::string_view description) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 0.005, .softMax = 1, .hardMin = 1e-4, .hardMax = 5, .defaultValue = defaultValue,
          .scale = ParameterScale::logarithmic, .description = description,
          .formula = "D = exp(-tan^2 theta_h / m^2) / (pi m^2 cos^4 theta_h)", .reference = guenther,
          .role = ParameterRole::width};
}

constexpr ParameterSpec reflectanceParameter(std::string_view id, std::string_view label, std::string_view symbol,
                                             double defaultValue, std::string_view description) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 1, .defaultValue = defaultValue,
          .group = ParameterGroup::fresnel, .description = description, .formula = "F = F(cos theta_d, F_0)",
          .reference = guenther, .role = ParameterRole::normalReflectance};
}

constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.1),
    strengthParameter("coat", "Coat", "k_1", 1, ParameterRole::coat, "Strength and tint of the clear coat's "
                                                                     "highlight."),
    widthParameter("coat-roughness", "Coat roughness", "m_1", 0.02, "Width of the clear coat's highlight."),
    reflectanceParameter("coat-f0", "Coat reflectance", "F_1", 0.04,
                         "Reflectance of the clear coat at normal incidence; lacquer is near 0.04."),
    strengthParameter("flakes", "Flakes", "k_2", 0.3, ParameterRole::highlight,
                      "Strength and tint of the glow of flakes that lie flat."),
    widthParameter("flakes-roughness", "Flake roughness", "m_2", 0.15, "How far the flat flakes tilt."),
    reflectanceParameter("flakes-f0", "Flake reflectance", "F_2", 0.5,
                         "Reflectance of the flat flakes at normal incidence."),
    strengthParameter("haze", "Haze", "k_3", 0.2, ParameterRole::highlight,
        "Strength and tint of the wide glow of disordered flakes."),
    widthParameter("haze-roughness", "Haze roughness", "m_3", 0.45, "How far the disordered flakes tilt."),
    reflectanceParameter("haze-f0", "Haze reflectance", "F_3", 0.5,
                         "Reflectance of the disordered flakes at normal incidence."),
    choiceParameter("normalisation", "Normalisation", "N",
                    "Constant N in the denominator of the highlights, which differs between publications.",
                    "walter: 4 (conserves energy); rump: pi", guenther, normalisations),
    fresnelParameter(FresnelChoice::schlick),
    edgeTintParameter(),
};

constexpr ModelSpec carPaintSpec = {
    .id = "car-paint", .name = "Car paint",
    .description = "Three Cook-Torrance lobes over a matte base: clear coat, flat flakes and disordered flakes, "
                   "without the sparkle of single flakes. Reciprocal; conserves energy with normalisation 'walter'; "
                   "the energy is too high by a factor of up to 4/pi with 'rump'.",
    .formula = "k_d / pi + sum over three lobes of k D F G / (N cos theta_i cos theta_o)", .reference = guenther,
    .parameters = parameters, .conservesEnergy = true};
// clang-format on

/// Index of the strength of a lobe; its roughness and reflectance follow.
constexpr std::size_t firstOf(int lobe) { return firstLobe + 3 * std::size_t(lobe); }

Fresnel fresnelOf(const ParameterValues& p, int lobe) {
  return chosenFresnel(p, fresnelTerm, edgeTint, p.values[firstOf(lobe) + 2].x);
}

auto lobeArguments(const ParameterValues& p, int lobe) {
  const double denominator = chosen(p.values[normalisation].x) == 0 ? 4 : pi, m = p.values[firstOf(lobe) + 1].x;
  return std::tuple(p.values[firstOf(lobe)] / denominator, 1 / (m * m), fresnelOf(p, lobe));
}

auto arguments(const ParameterValues& p) {
  return std::tuple_cat(std::tuple(p.values[diffuse] / pi), lobeArguments(p, 0), lobeArguments(p, 1),
                        lobeArguments(p, 2));
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const auto albedo = [&](int lobe) {
    return maxChannel(std::get<0>(lobeArguments(p, lobe))) * 4 * fresnelOf(p, lobe)(typicalCosine);
  };
  const auto normals = [&](int lobe) {
    const double m = p.values[firstOf(lobe) + 1].x;
    return HalfVectorDensity{BeckmannNormals{m, m}};
  };
  return makeGeometryBrdf(
      bound<glsl::formula_car_paint, ranges::formula_car_paint>(arguments(p)),
      DensityMixture(mixtureFractions(std::array{maxChannel(p.values[diffuse]), albedo(0), albedo(1), albedo(2)}),
                     CosineDensity{}, normals(0), normals(1), normals(2)));
}

/// Each term alone, by the same formula with all others black.
std::vector<ModelLobe> parts(const ParameterValues& p) {
  ParameterValues black = p;
  for (std::size_t i = 0; i < p.values.size(); ++i)
    if (parameters[i].linear) black.values[i] = Rgb(0);
  const auto alone = [&](std::size_t strength) {
    ParameterValues one = black;
    one.values[strength] = p.values[strength];
    return create(one);
  };
  std::vector<ModelLobe> result;
  result.push_back({alone(diffuse), {}, {p.values[diffuse]}, {}});
  for (int lobe = 0; lobe < lobes; ++lobe) {
    const std::size_t first = firstOf(lobe);
    const double m = p.values[first + 1].x;
    result.push_back({alone(first),
                      {m, m},
                      {p.values[first]},
                      {p.values[first + 1], p.values[first + 2], p.values[normalisation], p.values[fresnelTerm],
                       p.values[edgeTint]}});
  }
  return result;
}

}  // namespace

const Model& carPaint() {
  static const Model model(carPaintSpec, {.create = create, .arguments = shaderArguments<arguments>, .lobes = parts});
  return model;
}

}  // namespace gonio::models
