// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/cosine_power.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace {

constexpr std::string_view lewis1994 =
    "Lewis 1994, Making Shaders More Physically Plausible (normalisation derived here)";
constexpr std::string_view lobeChoices[] = {"reflection", "half-vector"};

enum Index { diffuse, specular, exponent, lobeKind };

// clang-format off
constexpr ParameterSpec parameters[] = {
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
    .reference = lewis1994, .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double n = p.values[exponent].x;
  const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular];
  const double diffuseAlbedo = maxChannel(p.values[diffuse]), albedo = maxChannel(ks);
  if (chosen(p.values[lobeKind].x) == 0)
    return makeGeometryBrdf(
        [=, ks = ks * reflectionNormalisation(n)](const SurfaceGeometry& g) { return kd + ks * reflectionPower(g, n); },
        diffuseMixture(diffuseAlbedo, albedo, CosinePowerDensity{n}));
  return makeGeometryBrdf(
      [=, ks = ks * halfVectorNormalisation(n)](const SurfaceGeometry& g) { return kd + ks * halfVectorPower(g, n); },
      diffuseMixture(diffuseAlbedo, albedo, HalfVectorDensity{CosinePowerNormals{n, n}}));
}

}  // namespace

const Model& lewis() {
  static const Model model(lewisSpec, {.create = create});
  return model;
}

}  // namespace gonio::models
