// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>

#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

/// The two ABC models, based on Church's power spectrum of polished surfaces.
namespace gonio::models {

namespace glsl {
#include "core/models/abc.glsl"
}
namespace ranges {
#include "core/models/abc.glsl"
}

namespace {

constexpr std::string_view loew =
    "Löw, Kronander, Ynnerman and Unger 2012, BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces";

constexpr std::string_view microfacetFormula = "S = A / (1 + B (1 - cos theta_h))^C";
constexpr std::string_view smoothFormula = "S = A / (1 + B |i_p + o_p|^2)^C, i_p and o_p projected onto the surface";
constexpr std::string_view normalisations[] = {"pi", "one"};
constexpr std::string_view angles[] = {"exact", "projected"};

enum Index { diffuse, amplitude, narrowness, falloff, refractiveIndex };
enum AbcIndex { normalisation = refractiveIndex + 1, abcFresnel, abcEdgeTint };
enum SmoothIndex { smoothFresnel = refractiveIndex + 1, smoothEdgeTint, fresnelAngle };

// clang-format off
// The hard ranges include all published fits of the 100 MERL materials (A up to 5710, B up to 8.1e6, C 0.014 to 2.7).
constexpr ParameterSpec amplitudeParameter(std::string_view formula) {
  return {.id = "a", .label = "Amplitude", .symbol = "A", .unit = "",
          .softMin = 0, .softMax = 1000, .hardMin = 0, .hardMax = 1e6, .defaultValue = 50,
          .perChannel = true, .linear = true,
          .description = "Strength and tint of the highlight, which is not normalised: raise it as the highlight "
                         "narrows.",
          .formula = formula, .reference = loew, .role = ParameterRole::peak};
}
constexpr ParameterSpec narrownessParameter(std::string_view formula) {
  return {.id = "b", .label = "Narrowness", .symbol = "B", .unit = "",
          .softMin = 10, .softMax = 1e6, .hardMin = 1e-3, .hardMax = 1e9, .defaultValue = 1000,
          .scale = ParameterScale::logarithmic,
          .description = "Where the falloff of the highlight begins: large values are glossy.",
          .formula = formula, .reference = loew, .role = ParameterRole::sharpness};
}
constexpr ParameterSpec falloffParameter(std::string_view formula) {
  return {.id = "c", .label = "Falloff", .symbol = "C", .unit = "",
          .softMin = 0.1, .softMax = 3, .hardMin = 0, .hardMax = 20, .defaultValue = 1,
          .description = "How fast the highlight falls off beyond its core: small values leave a wide haze.",
          .formula = formula, .reference = loew};
}

constexpr ParameterSpec smoothParameters[] = {
    diffuseParameter(0.2),
    amplitudeParameter(smoothFormula),
    narrownessParameter(smoothFormula),
    falloffParameter(smoothFormula),
    refractiveIndexParameter(loew),
    fresnelParameter(FresnelChoice::dielectric),
    edgeTintParameter(),
    choiceParameter("fresnel-angle", "Fresnel angle", "theta_d",
                    "Angle of the Fresnel term: the published fits use that of the projected directions.",
                    "exact: cos theta_d = h . i; projected: cos theta_d = sqrt(1 - |i_p - o_p|^2 / 4)", loew,
                    angles),
};

constexpr ModelSpec abcSmoothSpec = {
    .id = "abc-smooth", .name = "ABC smooth",
    .description = "Scattering of polished surfaces (Rayleigh and Rice), radially symmetric about the mirror direction "
                   "on the disk of projected directions. Reciprocal; the amplitude is free, so nothing bounds the "
                   "energy.",
    .formula = "k_d / pi + S F, S = A / (1 + B |i_p + o_p|^2)^C", .reference = loew,
    .parameters = smoothParameters, .file = "abc"};

constexpr ParameterSpec abcParameters[] = {
    diffuseParameter(0.2),
    amplitudeParameter(microfacetFormula),
    narrownessParameter(microfacetFormula),
    falloffParameter(microfacetFormula),
    refractiveIndexParameter(loew),
    choiceParameter("normalisation", "Normalisation", "N",
                    "Constant N in the denominator of the highlight: pi in the published fits, 1 in the printed "
                    "equation.",
                    "A ... / (N cos theta_i cos theta_o)", loew, normalisations),
    fresnelParameter(FresnelChoice::dielectric),
    edgeTintParameter(),
};

constexpr ModelSpec abcSpec = {
    .id = "abc", .name = "ABC microfacet",
    .description = "Microfacets with the inverse-power distribution of polished surfaces (Church), V-cavity masking. "
                   "Reciprocal; the amplitude is free, so nothing bounds the energy.",
    .formula = "k_d / pi + S G F / (N cos theta_i cos theta_o), S = A / (1 + B (1 - cos theta_h))^C",
    .reference = loew, .parameters = abcParameters};
// clang-format on

/// The integral of glsl::abcLobe() over x in [0, 1].
double lobeIntegral(const ParameterValues& p) {
  const double b = p.values[narrowness].x, end = std::log1p(b), e = 1 - p.values[falloff].x;
  return std::abs(e) * end < 1e-9 ? end / b : std::expm1(e * end) / (e * b);
}

Fresnel fresnelOf(const ParameterValues& p, std::size_t term, std::size_t edgeTint) {
  return chosenFresnel(p, term, edgeTint, normalReflectanceFromIndex(p.values[refractiveIndex].x));
}

auto smoothArguments(const ParameterValues& p) {
  return std::tuple(p.values[diffuse] / pi, p.values[amplitude], p.values[narrowness].x, p.values[falloff].x,
                    fresnelOf(p, smoothFresnel, smoothEdgeTint), chosen(p.values[fresnelAngle].x) == 0 ? 0.0 : 0.5);
}

std::unique_ptr<const Brdf> createSmooth(const ParameterValues& p) {
  const double reflectance = fresnelOf(p, smoothFresnel, smoothEdgeTint)(typicalCosine);
  return makeGeometryBrdf(bound<glsl::formula_abc_smooth, ranges::formula_abc_smooth>(smoothArguments(p)),
                          // The integral over the plane is pi times that over the squared radius.
                          diffuseMixture(maxChannel(p.values[diffuse]),
                                         pi * maxChannel(p.values[amplitude]) * lobeIntegral(p) * reflectance,
                                         DiskDensity{RationalRadial{p.values[narrowness].x, p.values[falloff].x}}));
}

auto abcArguments(const ParameterValues& p) {
  const double denominator = chosen(p.values[normalisation].x) == 0 ? pi : 1;
  return std::tuple(p.values[diffuse] / pi, p.values[amplitude] / denominator, p.values[narrowness].x,
                    p.values[falloff].x, fresnelOf(p, abcFresnel, abcEdgeTint));
}

std::unique_ptr<const Brdf> createAbc(const ParameterValues& p) {
  const auto [kd, a, b, c, fresnel] = abcArguments(p);
  const double albedo = 8 * pi * maxChannel(a) * lobeIntegral(p) * fresnel(typicalCosine);
  const TabulatedNormals normals([b = b, c = c](double thetaH) {
    const double s = std::sin(thetaH / 2);
    return glsl::abcLobe(2 * s * s, b, c);
  });
  return makeGeometryBrdf(bound<glsl::formula_abc, ranges::formula_abc>(abcArguments(p)),
                          diffuseMixture(maxChannel(p.values[diffuse]), albedo, HalfVectorDensity{normals}));
}

}  // namespace

const Model& abcSmooth() {
  static const Model model(abcSmoothSpec, {.create = createSmooth, .arguments = shaderArguments<smoothArguments>});
  return model;
}

const Model& abc() {
  static const Model model(abcSpec, {.create = createAbc, .arguments = shaderArguments<abcArguments>});
  return model;
}

}  // namespace gonio::models
