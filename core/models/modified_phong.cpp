// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/cosine_power.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/direction_densities.h"

namespace gonio::models {

namespace {

constexpr std::string_view lafortuneWillems =
    "Lafortune and Willems 1994, Using the Modified Phong Reflectance Model for Physically Based Rendering";

enum Index { diffuse, specular, exponent };

// clang-format off
constexpr ParameterSpec parameters[] = {
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
    .reference = lafortuneWillems, .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double n = p.values[exponent].x;
  const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular] * reflectionNormalisation(n);
  return makeGeometryBrdf(
      [=](const SurfaceGeometry& g) { return kd + ks * reflectionPower(g, n); },
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]), CosinePowerDensity{n}));
}

}  // namespace

const Model& modifiedPhong() {
  static const Model model(modifiedPhongSpec, {.create = create});
  return model;
}

}  // namespace gonio::models
