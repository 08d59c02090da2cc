// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/common_parameters.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"

namespace gonio::models {

namespace {

// clang-format off
constexpr ParameterSpec parameters[] = {diffuseParameter(0.5)};

constexpr ModelSpec lambertSpec = {
    .id = "lambert", .name = "Lambert",
    .description = "The ideal matte surface: equally bright from every direction. Reciprocal; albedo exactly k_d.",
    .formula = "k_d / pi", .reference = "Lambert 1760, Photometria", .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  return makeGeometryBrdf([kd = p.values[0] / pi](const SurfaceGeometry&) { return kd; });
}

}  // namespace

const Model& lambert() {
  static const Model model(lambertSpec, {.create = create});
  return model;
}

}  // namespace gonio::models
