// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <array>
#include <cmath>

#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

/// The lobes of Phong, about the mirror direction, and of Blinn, about the half vector, and the models made of them.
/// They differ in what scales the lobe.
namespace gonio::models {

namespace glsl {
#include "core/models/cosine_lobes.glsl"
}
namespace ranges {
#include "core/models/cosine_lobes.glsl"
}

namespace {

constexpr std::string_view phong1975 = "Phong 1975, Illumination for Computer Generated Pictures";
constexpr std::string_view blinn = "Blinn 1977, Models of Light Reflection for Computer Synthesized Pictures";
constexpr std::string_view lewis1994 =
    "Lewis 1994, Making Shaders More Physically Plausible (normalisation derived here)";
constexpr std::string_view lafortuneWillems =
    "Lafortune and Willems 1994, Using the Modified Phong Reflectance Model for Physically Based Rendering";
constexpr std::string_view neumann1999 = "Neumann, Neumann and Szirmay-Kalos 1999, Compact Metallic Reflectance Models";
constexpr std::string_view blinnNormalisations[] = {"half-vector", "unit-albedo", "none"};
constexpr std::string_view lobeChoices[] = {"reflection", "half-vector"};
constexpr std::string_view neumannNormalisations[] = {"energy", "none"};

/// The last only where a model has a choice.
enum Index { diffuse, specular, exponent, choice };
enum Normalisation { halfVector, unitAlbedo, none };

// clang-format off
constexpr ParameterSpec phongParameters[] = {
    diffuseParameter(0.2),
    withRole(specularParameter(0.5, "k_s max(0, cos alpha)^n, alpha from the mirror direction", phong1975),
             ParameterRole::peak),
    exponentParameter("cos^n alpha", phong1975),
};

constexpr ModelSpec phongSpec = {
    .id = "phong", .name = "Phong",
    .description = "A cosine lobe about the mirror direction, not normalised, as the literature quotes it. Reciprocal. "
                   "The albedo of the highlight depends on the exponent and exceeds 1 for broad lobes.",
    .formula = "k_d / pi + k_s max(0, cos alpha)^n",
    .reference = phong1975, .parameters = phongParameters, .file = "cosine_lobes",
    .family = ModelFamily::empirical};

constexpr ParameterSpec blinnParameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1, "k_s N cos^n theta_h", blinn),
    exponentParameter("cos^n theta_h", blinn),
    choiceParameter("normalisation", "Normalisation", "N",
                    "Scales the highlight with its sharpness so that its energy stays constant.",
                    "half-vector: (n + 2) / (8 pi); unit-albedo: (n + 2)(n + 4) / (8 pi (n + 2^(-n/2))); none: 1",
                    "Schüler 2011, The Blinn-Phong Normalization Zoo", blinnNormalisations),
};

constexpr ModelSpec blinnPhongSpec = {
    .id = "blinn-phong", .name = "Blinn-Phong",
    .description = "A cosine lobe about the half vector; simple and fast. Reciprocal; darkens towards grazing "
                   "angles. With the normalisation 'none' the albedo of the highlight depends on the exponent and "
                   "exceeds 1 for broad lobes.",
    .formula = "k_d / pi + k_s N cos^n theta_h", .reference = blinn, .parameters = blinnParameters, .file = "cosine_lobes",
    .family = ModelFamily::empirical, .conservesEnergy = true};

constexpr ParameterSpec lewisParameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1, "k_s N cos^n, at most k_s of the light is reflected", lewis1994),
    exponentParameter("cos^n alpha or cos^n theta_h", lewis1994),
    choiceParameter("lobe", "Lobe", "N cos^n",
                    "Centre of the highlight: the mirror direction (Phong) or the half vector (Blinn).",
                    "reflection: (n + 2) / (2 pi) cos^n alpha; "
                    "half-vector: (n + 2)(n + 4) / (8 pi (n + 2^(-n/2))) cos^n theta_h",
                    lewis1994, lobeChoices),
};

constexpr ModelSpec lewisSpec = {
    .id = "lewis", .name = "Lewis",
    .description = "Phong's and Blinn's shaders made plausible: reciprocal, and normalised by their maximum albedo, at "
                   "normal incidence, so that k_d + k_s <= 1 conserves energy. With the lobe 'reflection' it equals "
                   "modified Phong.",
    .formula = "k_d / pi + k_s N cos^n, k_d + k_s <= 1",
    .reference = lewis1994, .parameters = lewisParameters, .file = "cosine_lobes",
    .family = ModelFamily::empirical, .conservesEnergy = true};

constexpr ParameterSpec modifiedPhongParameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1, "k_s (n + 2) / (2 pi) max(0, cos alpha)^n, alpha from the mirror direction",
                      lafortuneWillems),
    exponentParameter("cos^n alpha", lafortuneWillems),
};

constexpr ModelSpec modifiedPhongSpec = {
    .id = "modified-phong", .name = "Modified Phong",
    .description = "Phong's lobe with normalised energy: the albedo of the highlight is k_s at normal incidence and "
                   "less elsewhere, where part of the lobe lies below the horizon. Reciprocal; darkens towards grazing "
                   "angles.",
    .formula = "k_d / pi + k_s (n + 2) / (2 pi) max(0, cos alpha)^n, k_d + k_s <= 1",
    .reference = lafortuneWillems, .parameters = modifiedPhongParameters, .file = "cosine_lobes",
    .family = ModelFamily::empirical, .conservesEnergy = true};

constexpr std::array<ParameterSpec, 4> neumannParameters(std::string_view specularFormula, std::string_view powerFormula,
                                                    std::string_view normalisationFormula) {
  return {diffuseParameter(0.2),
          specularParameter(0.1, specularFormula, neumann1999),
          exponentParameter(powerFormula, neumann1999),
          choiceParameter("normalisation", "Normalisation", "N",
                          "Scales the highlight with its sharpness so that its energy stays constant.",
                          normalisationFormula, neumann1999, neumannNormalisations)};
}

constexpr auto neumannBlinnParameters = neumannParameters(
    "k_s N cos^n theta_h / max(cos theta_i, cos theta_o)", "cos^n theta_h",
    "energy: (n + 1) / (8 pi) (derived here: bounds the albedo by k_s); none: 1");

constexpr auto neumannPhongParameters = neumannParameters(
    "k_s N max(0, cos alpha)^n / max(cos theta_i, cos theta_o)", "max(0, cos alpha)^n",
    "energy: (n + 1) / (2 pi) (derived here: bounds the albedo by k_s); none: 1");

constexpr ModelSpec neumannBlinnSpec = {
    .id = "neumann-blinn", .name = "Neumann-Neumann (Blinn)",
    .description = "Blinn's lobe divided by the larger cosine, for metals. Reciprocal. With the normalisation "
                   "'energy' the albedo of the highlight never exceeds k_s; with 'none' it depends on the exponent "
                   "and exceeds 1 for broad lobes.",
    .formula = "k_d / pi + k_s N cos^n theta_h / max(cos theta_i, cos theta_o)",
    .reference = neumann1999, .parameters = neumannBlinnParameters, .file = "cosine_lobes",
    .family = ModelFamily::empirical, .conservesEnergy = true};

constexpr ModelSpec neumannPhongSpec = {
    .id = "neumann-phong", .name = "Neumann-Neumann (Phong)",
    .description = "Phong's lobe divided by the larger cosine, for metals. Reciprocal. With the normalisation "
                   "'energy' the albedo of the highlight never exceeds k_s; with 'none' it depends on the exponent "
                   "and exceeds 1 for broad lobes.",
    .formula = "k_d / pi + k_s N max(0, cos alpha)^n / max(cos theta_i, cos theta_o)",
    .reference = neumann1999, .parameters = neumannPhongParameters, .file = "cosine_lobes",
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

/// The lobes about the mirror direction and about the half vector, to sample them.
CosinePowerDensity reflectionDensity(double n) { return {n}; }
HalfVectorDensity<CosinePowerNormals> halfVectorDensity(double n) {
  return HalfVectorDensity{CosinePowerNormals{n, n}};
}

double blinnNormalisation(double n, int normalisation) {
  if (normalisation == halfVector) return (n + 2) / (8 * pi);
  if (normalisation == unitAlbedo) return halfVectorNormalisation(n);
  return 1;
}

/// k_d / pi, k_s times `factor` and n.
auto argumentsOf(const ParameterValues& p, double factor) {
  return std::tuple(p.values[diffuse] / pi, p.values[specular] * factor, p.values[exponent].x);
}

auto phongArguments(const ParameterValues& p) { return argumentsOf(p, 1); }
auto modifiedPhongArguments(const ParameterValues& p) {
  return argumentsOf(p, reflectionNormalisation(p.values[exponent].x));
}
auto blinnArguments(const ParameterValues& p) {
  return argumentsOf(p, blinnNormalisation(p.values[exponent].x, chosen(p.values[choice].x)));
}
auto lewisArguments(const ParameterValues& p) {
  const double n = p.values[exponent].x;
  const bool aboutHalfVector = chosen(p.values[choice].x) == 1;
  const double factor = aboutHalfVector ? halfVectorNormalisation(n) : reflectionNormalisation(n);
  return std::tuple_cat(argumentsOf(p, factor), std::tuple(aboutHalfVector ? 1.0 : 0.0));
}
/// The factors of Neumann's lobes that bound their albedo by k_s, 1/sr.
double neumannPhongBound(double n) { return (n + 1) / (2 * pi); }
double neumannBlinnBound(double n) { return (n + 1) / (8 * pi); }
template <double (*boundOf)(double)>
auto neumannArguments(const ParameterValues& p) {
  return argumentsOf(p, chosen(p.values[choice].x) == 0 ? boundOf(p.values[exponent].x) : 1);
}

/// @param albedo of the highlight for k_s = 1, to sample it.
template <auto formula, auto rangeFormula, typename Arguments, typename Density>
std::unique_ptr<const Brdf> makeBrdf(const ParameterValues& p, const Arguments& arguments, double albedo,
                                     const Density& density) {
  return makeGeometryBrdf(
      bound<formula, rangeFormula>(arguments),
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]) * albedo, density));
}

std::unique_ptr<const Brdf> createPhong(const ParameterValues& p) {
  const double n = p.values[exponent].x;
  return makeBrdf<glsl::formula_phong, ranges::formula_phong>(p, phongArguments(p), 1 / reflectionNormalisation(n),
                                                              reflectionDensity(n));
}

std::unique_ptr<const Brdf> createModifiedPhong(const ParameterValues& p) {
  return makeBrdf<glsl::formula_phong, ranges::formula_phong>(p, modifiedPhongArguments(p), 1,
                                                              reflectionDensity(p.values[exponent].x));
}

std::unique_ptr<const Brdf> createBlinn(const ParameterValues& p) {
  return makeBrdf<glsl::formula_blinn_phong, ranges::formula_blinn_phong>(p, blinnArguments(p), 1,
                                                                          halfVectorDensity(p.values[exponent].x));
}

std::unique_ptr<const Brdf> createLewis(const ParameterValues& p) {
  const auto [kd, ks, n, aboutHalfVector] = lewisArguments(p);
  const std::tuple arguments(kd, ks, n);
  return aboutHalfVector == 1
             ? makeBrdf<glsl::formula_blinn_phong, ranges::formula_blinn_phong>(p, arguments, 1, halfVectorDensity(n))
             : makeBrdf<glsl::formula_phong, ranges::formula_phong>(p, arguments, 1, reflectionDensity(n));
}

std::unique_ptr<const Brdf> createNeumannPhong(const ParameterValues& p) {
  const double n = p.values[exponent].x, albedo = chosen(p.values[choice].x) == 0 ? 1 : 1 / neumannPhongBound(n);
  return makeBrdf<glsl::formula_neumann_phong, ranges::formula_neumann_phong>(p, neumannArguments<neumannPhongBound>(p),
                                                                              albedo, reflectionDensity(n));
}

std::unique_ptr<const Brdf> createNeumannBlinn(const ParameterValues& p) {
  const double n = p.values[exponent].x, albedo = chosen(p.values[choice].x) == 0 ? 1 : 1 / neumannBlinnBound(n);
  return makeBrdf<glsl::formula_neumann_blinn, ranges::formula_neumann_blinn>(p, neumannArguments<neumannBlinnBound>(p),
                                                                              albedo, halfVectorDensity(n));
}

}  // namespace

const Model& phong() {
  static const Model model(phongSpec, {.create = createPhong, .arguments = shaderArguments<phongArguments>});
  return model;
}

const Model& blinnPhong() {
  static const Model model(blinnPhongSpec, {.create = createBlinn, .arguments = shaderArguments<blinnArguments>});
  return model;
}

const Model& lewis() {
  static const Model model(lewisSpec, {.create = createLewis, .arguments = shaderArguments<lewisArguments>});
  return model;
}

const Model& modifiedPhong() {
  static const Model model(modifiedPhongSpec,
                           {.create = createModifiedPhong, .arguments = shaderArguments<modifiedPhongArguments>});
  return model;
}

const Model& neumannPhong() {
  static const Model model(neumannPhongSpec, {.create = createNeumannPhong,
                                              .arguments = shaderArguments<neumannArguments<neumannPhongBound>>});
  return model;
}

const Model& neumannBlinn() {
  static const Model model(neumannBlinnSpec, {.create = createNeumannBlinn,
                                              .arguments = shaderArguments<neumannArguments<neumannBlinnBound>>});
  return model;
}

}  // namespace gonio::models
