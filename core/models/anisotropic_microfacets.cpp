// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <array>

#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

/// Microfacets with a width along the grain and another across it, under Smith's masking: of GGX and of Beckmann.
namespace gonio::models {

namespace glsl {
INLINE REAL ggxDensity(const vec3& h, const vec2& alpha) { return gonio::ggxDensity(h, alpha.x, alpha.y); }
INLINE REAL ggxCosineOverG1(const vec3& w, const vec2& alpha) { return gonio::ggxCosineOverG1(w, alpha.x, alpha.y); }
inline REAL beckmannDensity(const vec3& h, const vec2& alpha) { return gonio::beckmannDensity(h, alpha.x, alpha.y); }
inline REAL beckmannCosineOverG1(const vec3& w, const vec2& alpha) {
  return gonio::beckmannCosineOverG1(w, alpha.x, alpha.y);
}
#include "core/models/anisotropic_microfacets.glsl"
}  // namespace glsl
namespace ranges {
REAL ggxDensity(const vec3& h, const vec2& alpha) {
  const REAL product = alpha.x * alpha.y, across = alpha.y / alpha.x, along = alpha.x / alpha.y;
  const REAL slope = square(h.x) * across + square(h.y) * along + product * square(h.z);
  return product / (REAL(pi) * square(slope));
}
/// cos theta (1 + Lambda) rises with the cosine and with the slope.
REAL slopeOf(const vec3& w, const vec2& alpha) { return sqrt(square(alpha.x * w.x) + square(alpha.y * w.y)); }
REAL ggxCosineOverG1(const vec3& w, const vec2& alpha) {
  return (w.z + sqrt(square(slopeOf(w, alpha)) + square(w.z))) / 2.0;
}
REAL beckmannDensity(const vec3& h, const vec2& alpha) {
  const REAL cos2 = max(square(h.z), REAL(1e-18)), slopes = square(h.x / alpha.x) + square(h.y / alpha.y);
  return exp(-slopes / cos2) / (REAL(pi) * alpha.x * alpha.y * square(cos2));
}
REAL beckmannCosineOverG1(const vec3& w, const vec2& alpha) {
  const REAL slope = slopeOf(w, alpha);
  return {gonio::beckmannCosineOverG1({slope.low, 0, w.z.low}, 1, 1),
          gonio::beckmannCosineOverG1({slope.high, 0, w.z.high}, 1, 1)};
}
#include "core/models/anisotropic_microfacets.glsl"
}  // namespace ranges

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
    .parameters = ggxParameters, .file = "anisotropic_microfacets", .conservesEnergy = true};

constexpr ModelSpec beckmannSpec = {
    .id = "beckmann-anisotropic", .name = "Beckmann, anisotropic",
    .description = "Microfacets with Gaussian slopes, separate widths along x and y, and Smith masking. "
                   "Reciprocal; loses a little energy at high roughness (single scattering).",
    .formula = formula,
    .reference = "Heitz 2014, Understanding the Masking-Shadowing Function, section 5; Beckmann "
                 "and Spizzichino 1963, The Scattering of Electromagnetic Waves from Rough Surfaces",
    .parameters = beckmannParameters, .file = "anisotropic_microfacets", .conservesEnergy = true};
// clang-format on

Fresnel fresnelOf(const ParameterValues& p) {
  return chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
}

auto arguments(const ParameterValues& p) {
  return std::tuple(p.values[diffuse] / pi, p.values[specular] / 4.0,
                    glm::dvec2(p.values[roughnessX].x, p.values[roughnessY].x), grainAxis(p.values[rotation].x),
                    double(chosen(p.values[masking].x)), fresnelOf(p));
}

/// @tparam Lobe the sampler of the distribution.
template <auto formula, auto rangeFormula, typename Lobe>
std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double x = p.values[roughnessX].x, y = p.values[roughnessY].x;
  return makeGeometryBrdf(
      bound<formula, rangeFormula>(arguments(p)),
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]) * fresnelOf(p)(typicalCosine),
                     RotatedDensity(Lobe{x, y}, p.values[rotation].x)),
      x == y);
}

ParameterValues canonical(const ParameterValues& p) { return alongGrain(p, {roughnessX, roughnessY, rotation}, true); }

template <auto create>
std::vector<ModelLobe> parts(const ParameterValues& p) {
  return diffuseAndHighlight(create, p, {p.values[roughnessX].x, p.values[roughnessY].x, p.values[rotation].x});
}

template <auto create>
constexpr Model::Functions functions{
    .create = create, .arguments = shaderArguments<arguments>, .lobes = parts<create>, .canonical = canonical};

}  // namespace

const Model& ggxAnisotropic() {
  static const Model model(
      ggxSpec, functions<create<glsl::formula_ggx_anisotropic, ranges::formula_ggx_anisotropic, VisibleNormalDensity>>);
  return model;
}

const Model& beckmannAnisotropic() {
  static const Model model(
      beckmannSpec,
      functions<
          create<glsl::formula_beckmann_anisotropic, ranges::formula_beckmann_anisotropic, BeckmannVisibleDensity>>);
  return model;
}

}  // namespace gonio::models
