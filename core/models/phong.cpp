// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/cosine_power.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/direction_densities.h"

namespace gonio::models {

namespace {

constexpr std::string_view phong1975 = "Phong 1975, Illumination for Computer Generated Pictures";

enum Index { diffuse, specular, exponent };

// clang-format off
constexpr ParameterSpec parameters[] = {
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
    .reference = phong1975, .parameters = parameters,
    .family = ModelFamily::empirical};
// clang-format on

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double n = p.values[exponent].x;
  const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular];
  return makeGeometryBrdf([=](const SurfaceGeometry& g) { return kd + ks * reflectionPower(g, n); },
                          diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(ks) / reflectionNormalisation(n),
                                         CosinePowerDensity{n}));
}

}  // namespace

const Model& phong() {
  static const Model model(phongSpec, {.create = create});
  return model;
}

}  // namespace gonio::models
