// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "core/models/fresnel.h"
#include "core/models/model.h"
#include "core/models/shader_arguments.h"
#include "core/sampling/half_vector_densities.h"

/// What several models share: parameters with the same meaning, and parts of their functions.
namespace gonio::models {

// clang-format off
constexpr ParameterSpec diffuseParameter(double defaultValue) {
  return {.id = "diffuse", .label = "Diffuse colour", .symbol = "k_d", .unit = "",
          .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 10, .defaultValue = defaultValue,
          .group = ParameterGroup::diffuse, .perChannel = true, .linear = true,
          .description = "Fraction of the light that is scattered equally in all directions: the diffuse albedo.",
          .formula = "k_d / pi", .reference = "Lambert 1760, Photometria", .role = ParameterRole::diffuse};
}

constexpr ParameterSpec specularParameter(double defaultValue, std::string_view formula, std::string_view reference) {
  return {.id = "specular", .label = "Specular strength", .symbol = "k_s", .unit = "",
          .softMin = 0, .softMax = 2, .hardMin = 0, .hardMax = 100, .defaultValue = defaultValue,
          .perChannel = true, .linear = true,
          .description = "Strength and tint of the highlight.",
          .formula = formula, .reference = reference, .role = ParameterRole::highlight};
}

/// Roughness of microfacet models; small values are glossy. The hard minimum is 1e-4, where a lobe is narrower than any
/// light or measurement resolution.
constexpr ParameterSpec roughnessParameter(std::string_view symbol, std::string_view description,
                                           std::string_view formula, std::string_view reference,
                                           double hardMax = 1, double defaultValue = 0.3) {
  return {.id = "roughness", .label = "Roughness", .symbol = symbol, .unit = "",
          .softMin = 0.005, .softMax = 1, .hardMin = 1e-4, .hardMax = hardMax, .defaultValue = defaultValue,
          .scale = ParameterScale::logarithmic,
          .description = description, .formula = formula, .reference = reference, .role = ParameterRole::width};
}

/// Exponent of a cosine lobe; up to 6.3e5 in published fits of measured materials.
constexpr ParameterSpec exponentParameter(std::string_view formula, std::string_view reference) {
  return {.id = "exponent", .label = "Shininess", .symbol = "n", .unit = "",
          .softMin = 1, .softMax = 1e4, .hardMin = 1e-6, .hardMax = 1e6, .defaultValue = 50,
          .scale = ParameterScale::logarithmic,
          .description = "Sharpness of the highlight: large values are glossy.",
          .formula = formula, .reference = reference, .role = ParameterRole::sharpness};
}

constexpr ParameterSpec normalReflectanceParameter(double defaultValue = 0.04) {
  return {.id = "f0", .label = "Reflectance F0", .symbol = "F_0", .unit = "",
          .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 1, .defaultValue = defaultValue,
          .group = ParameterGroup::fresnel,
          .description = "Reflectance of the surface at normal incidence; metals are high, plastics near 0.04.",
          .formula = "F = F(cos theta_d, eta), eta = (1 + sqrt F_0) / (1 - sqrt F_0)",
          .reference = "Cook and Torrance 1982, A Reflectance Model for Computer Graphics",
          .role = ParameterRole::normalReflectance};
}

/// Replaces normalReflectanceParameter() in models for which the source publishes indices of refraction (fitted ones
/// have values up to 100).
constexpr ParameterSpec refractiveIndexParameter(std::string_view reference) {
  return {.id = "index-of-refraction", .label = "Index of refraction", .symbol = "eta", .unit = "",
          .softMin = 1, .softMax = 5, .hardMin = 1, .hardMax = 1000, .defaultValue = 1.5,
          .scale = ParameterScale::logarithmic, .group = ParameterGroup::fresnel,
          .description = "Index of refraction, which sets the reflectance at normal incidence; glass and plastics are "
                         "near 1.5.",
          .formula = "F = F(cos theta_d, F_0), F_0 = ((eta - 1) / (eta + 1))^2", .reference = reference,
          .role = ParameterRole::refractiveIndex};
}

constexpr ParameterSpec edgeTintParameter() {
  return {.id = "edge-tint", .label = "Edge tint", .symbol = "g", .unit = "",
          .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 1, .defaultValue = 0.5,
          .group = ParameterGroup::fresnel,
          .description = "How early the reflectance of a metal rises towards grazing angles; 0 is a dielectric.",
          .formula = "eta = g (1 - F_0) / (1 + F_0) + (1 - g) (1 + sqrt F_0) / (1 - sqrt F_0), "
                     "k^2 = (F_0 (eta + 1)^2 - (eta - 1)^2) / (1 - F_0), k: extinction coefficient",
          .reference = "Gulbrandsen 2014, Artist Friendly Metallic Fresnel",
          .activeWith = "fresnel", .activeChoice = int(FresnelChoice::conductor)};
}

/// Pairs of parameters along the grain of a surface (x) and across it (y), and the direction of the grain. If both are
/// equal, the surface is isotropic and the direction has no effect.
constexpr ParameterSpec roughnessXParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = roughnessParameter(
      "alpha_x", "Width of the highlight along x, the brushing direction; the highlight of brushed metal is narrow along x and wide across it.",
      formula, reference);
  spec.id = "roughness-x";
  spec.label = "Roughness x";
  return spec;
}
constexpr ParameterSpec roughnessYParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = roughnessParameter("alpha_y", "Width of the highlight along y, across the brushing direction.", formula, reference);
  spec.id = "roughness-y";
  spec.label = "Roughness y";
  spec.isotropicTwin = "roughness-x";
  return spec;
}
constexpr ParameterSpec exponentXParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = exponentParameter(formula, reference);
  spec.id = "exponent-x";
  spec.label = "Shininess x";
  spec.symbol = "n_x";
  spec.softMax = 1e5;
  spec.defaultValue = 100;
  spec.description = "Sharpness of the highlight along x, the brushing direction: large values are glossy.";
  return spec;
}
constexpr ParameterSpec exponentYParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = exponentXParameter(formula, reference);
  spec.id = "exponent-y";
  spec.label = "Shininess y";
  spec.symbol = "n_y";
  spec.description = "Sharpness of the highlight along y, across the brushing direction.";
  spec.isotropicTwin = "exponent-x";
  return spec;
}
/// The period is pi; the hard range is twice as large, so that fits and sliders do not stop at its ends.
constexpr ParameterSpec rotationParameter() {
  return {.id = "rotation", .label = "Rotation", .symbol = "psi", .unit = "rad",
          .softMin = -halfPi, .softMax = halfPi, .hardMin = -pi, .hardMax = pi, .defaultValue = 0,
          .scale = ParameterScale::angle,
          .description = "Brushing direction x: the angle from the surface tangent to x, counter-clockwise.",
          .formula = "h_x, h_y: h turned by -psi about the normal",
          .reference = "Ward 1992, Measuring and Modeling Anisotropic Reflection",
          .anisotropicOnly = true};
}

/// A choice between named conventions.
constexpr ParameterSpec choiceParameter(std::string_view id, std::string_view label, std::string_view symbol,
                                        std::string_view description, std::string_view formula,
                                        std::string_view reference, std::span<const std::string_view> choices,
                                        int defaultChoice = 0) {
  const double last = double(choices.size()) - 1;
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 0, .softMax = last, .hardMin = 0, .hardMax = last, .defaultValue = double(defaultChoice),
          .group = ParameterGroup::convention,
          .description = description, .formula = formula, .reference = reference, .choices = choices};
}
/// Choice of the Fresnel term. @param ofSource the term in the model's source, used as default.
constexpr ParameterSpec fresnelParameter(FresnelChoice ofSource) {
  return choiceParameter("fresnel", "Fresnel", "F",
                         "Fresnel term, the rise of the reflectance towards grazing angles: exact for glass and "
                         "plastic, exact for a metal, or Schlick's approximation.",
                         "dielectric: exact, k = 0; conductor: exact, eta + i k; "
                         "schlick: F_0 + (1 - F_0)(1 - cos theta_d)^5",
                         "Cook and Torrance 1982, A Reflectance Model for Computer Graphics; Born and Wolf, Principles of "
                         "Optics, 14.2; Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering",
                         fresnelChoices, int(ofSource));
}
// clang-format on

/// The parameter with another role, for models where its meaning differs.
constexpr ParameterSpec withRole(ParameterSpec spec, ParameterRole role) {
  spec.role = role;
  return spec;
}

/// Index of the choice nearest to a value.
constexpr int chosen(double value) { return int(value + 0.5); }

/// The Fresnel term that the parameters select. @param term, edgeTint indices of fresnelParameter() and
/// edgeTintParameter().
inline Fresnel chosenFresnel(const ParameterValues& p, std::size_t term, std::size_t edgeTint, double f0) {
  return {FresnelChoice(chosen(p.values[term].x)), f0, p.values[edgeTint].x};
}

/// Normalisation factor of cos^n theta_h, 1/sr: its directional albedo becomes 1 at normal incidence, where it is
/// largest.
inline double halfVectorNormalisation(double n) { return (n + 2) * (n + 4) / (8 * pi * (n + std::exp2(-n / 2))); }
/// The same for cos^n alpha.
inline double reflectionNormalisation(double n) { return (n + 2) / (2 * pi); }

/// Indices of the grain's parameters in a model.
struct GrainIndices {
  std::size_t x, y, rotation;
};

/// Parameters of the same surface with x along the narrower axis of the highlight, and a rotation in [-pi/2, pi/2), 0
/// if both axes are equal. For Model::canonical(). @param widthRises true if larger parameters widen the highlight
/// (roughness), false if they narrow it (exponent).
inline ParameterValues alongGrain(ParameterValues values, const GrainIndices& at, bool widthRises) {
  Rgb &x = values.values[at.x], &y = values.values[at.y], &rotation = values.values[at.rotation];
  if (x == y) {
    rotation = Rgb(0);
    return values;
  }
  double angle = rotation.x;
  if ((x.x > y.x) == widthRises) {
    std::swap(x, y);
    angle += halfPi;
  }
  angle -= pi * std::floor(angle / pi + 0.5);
  rotation = Rgb(angle < halfPi ? angle : -halfPi);  // the difference may round up
  return values;
}

/// The axis of the grain for glsl::inGrain().
inline glm::dvec2 grainAxis(double rotation) { return {std::cos(rotation), std::sin(rotation)}; }

/// cos theta_d at which samplers evaluate the Fresnel term to estimate the brightness of highlights.
inline constexpr double typicalCosine = 0.7;

/// Model::lobes() for models with k_d and k_s as the first parameters: the diffuse term and the highlight, each
/// evaluated by the model's formula with the other term set to 0. The highlight depends on all other parameters.
/// @param width of the highlight. @param ofDiffuse parameters besides k_d on which the diffuse term depends.
template <typename Create>
std::vector<ModelLobe> diffuseAndHighlight(const Create& create, const ParameterValues& p, const LobeWidth& width,
                                           std::vector<Rgb> ofDiffuse = {}) {
  constexpr std::size_t kd = 0, ks = 1;
  ParameterValues diffuseOnly = p, highlightOnly = p;
  diffuseOnly.values[ks] = highlightOnly.values[kd] = Rgb(0);
  std::vector<ModelLobe> result;
  result.push_back({create(diffuseOnly), {}, {p.values[kd]}, std::move(ofDiffuse)});
  result.push_back({create(highlightOnly), width, {p.values[ks]}, {p.values.begin() + ks + 1, p.values.end()}});
  return result;
}

/// A sampler for models without a distribution of normals: a diffuse part, and half vectors distributed as the
/// highlight at theta_d = 0. @param diffuseAlbedo of the diffuse part. @param excess callable with theta_h (rad),
/// returns the BRDF value of the highlight without the diffuse part, 1/sr, of any sign.
template <typename Excess>
DensityMixture<CosineDensity, HalfVectorDensity<TabulatedNormals>> excessSampler(double diffuseAlbedo,
                                                                                 const Excess& excess) {
  // d omega_i = 4 cos theta_d d omega_h, and about the mirror direction of a vertical viewer theta_d = theta_h.
  const TabulatedNormals normals(
      [&](double thetaH) { return 4 * std::max(0.0, excess(thetaH)) * std::cos(thetaH) * std::cos(thetaH); });
  return diffuseMixture(diffuseAlbedo, normals.total(), HalfVectorDensity{normals});
}

}  // namespace gonio::models
