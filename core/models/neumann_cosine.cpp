// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>

#include "core/models/cosine_power.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

/// The lobes of Blinn and Phong divided by the larger cosine.
namespace gonio::models {

namespace {

constexpr std::string_view neumann1999 = "Neumann, Neumann and Szirmay-Kalos 1999, Compact Metallic Reflectance Models";
constexpr std::string_view normalisations[] = {"energy", "none"};

enum Index { diffuse, specular, exponent, normalisation };

// clang-format off
constexpr std::array<ParameterSpec, 4> parametersOf(std::string_view specularFormula, std::string_view powerFormula,
                                                    std::string_view normalisationFormula) {
  return {diffuseParameter(0.2),
          specularParameter(0.1, specularFormula, neumann1999),
          exponentParameter(powerFormula, neumann1999),
          choiceParameter("normalisation", "Normalisation", "N",
                          "Scales the highlight with its sharpness so that its energy stays constant.",
                          normalisationFormula, neumann1999, normalisations)};
}

constexpr auto blinnParameters = parametersOf(
    "k_s N cos^n theta_h / max(cos theta_i, cos theta_o)", "cos^n theta_h",
    "energy: (n + 1) / (8 pi) (derived here: bounds the albedo by k_s); none: 1");

constexpr auto phongParameters = parametersOf(
    "k_s N max(0, cos alpha)^n / max(cos theta_i, cos theta_o)", "max(0, cos alpha)^n",
    "energy: (n + 1) / (2 pi) (derived here: bounds the albedo by k_s); none: 1");

constexpr ModelSpec blinnSpec = {
    .id = "neumann-blinn", .name = "Neumann-Neumann (Blinn)",
    .description = "Blinn's lobe divided by the larger cosine, for metals. Reciprocal. With the normalisation "
                   "'energy' the albedo of the highlight never exceeds k_s; with 'none' it depends on the exponent "
                   "and exceeds 1 for broad lobes.",
    .formula = "k_d / pi + k_s N cos^n theta_h / max(cos theta_i, cos theta_o)",
    .reference = neumann1999, .parameters = blinnParameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};

constexpr ModelSpec phongSpec = {
    .id = "neumann-phong", .name = "Neumann-Neumann (Phong)",
    .description = "Phong's lobe divided by the larger cosine, for metals. Reciprocal. With the normalisation "
                   "'energy' the albedo of the highlight never exceeds k_s; with 'none' it depends on the exponent "
                   "and exceeds 1 for broad lobes.",
    .formula = "k_d / pi + k_s N max(0, cos alpha)^n / max(cos theta_i, cos theta_o)",
    .reference = neumann1999, .parameters = phongParameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

/// @param bound (1/sr) makes the albedo of power / max(cos theta_i, cos theta_o) at most 1.
/// @param power double(const SurfaceGeometry&): the power of a cosine, which `lobe` samples.
template <typename Power, typename Lobe>
std::unique_ptr<const Brdf> makeCosineBrdf(const ParameterValues& p, double bound, Power power, Lobe lobe) {
  const double factor = chosen(p.values[normalisation].x) == 0 ? bound : 1;
  const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular] * factor;
  return makeGeometryBrdf([=](const SurfaceGeometry& g) { return kd + ks * (power(g) / std::max(g.cosI, g.cosO)); },
                          diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(ks) / bound, lobe));
}

std::unique_ptr<const Brdf> createBlinn(const ParameterValues& p) {
  const double n = p.values[exponent].x;
  return makeCosineBrdf(
      p, (n + 1) / (8 * pi), [n](const SurfaceGeometry& g) { return halfVectorPower(g, n); },
      HalfVectorDensity{CosinePowerNormals{n, n}});
}

std::unique_ptr<const Brdf> createPhong(const ParameterValues& p) {
  const double n = p.values[exponent].x;
  return makeCosineBrdf(
      p, (n + 1) / (2 * pi), [n](const SurfaceGeometry& g) { return reflectionPower(g, n); }, CosinePowerDensity{n});
}

}  // namespace

const Model& neumannBlinn() {
  static const Model model(blinnSpec, {.create = createBlinn});
  return model;
}

const Model& neumannPhong() {
  static const Model model(phongSpec, {.create = createPhong});
  return model;
}

}  // namespace gonio::models
