// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"

namespace gonio::models {

namespace {

constexpr ParameterSpec parameters[] = {
    {.id = "diffuse", .label = "Diffuse", .symbol = "k_d", .unit = "",
     .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 10, .defaultValue = 0.5,
     .group = ParameterGroup::diffuse, .perChannel = true, .linear = true,
     .description = "Share of the light that the material scatters evenly: its albedo.",
     .formula = "k_d / pi", .reference = "Lambert 1760, Photometria"},
};

constexpr ModelSpec lambertSpec = {
    .id = "lambert", .name = "Lambert",
    .description = "The ideal matte surface: looks equally bright from everywhere. Reciprocal; albedo exactly k_d.",
    .formula = "k_d / pi", .reference = "Lambert 1760, Photometria", .parameters = parameters};

class Lambert final : public Model {
 public:
  const ModelSpec& spec() const override { return lambertSpec; }

 protected:
  std::unique_ptr<const Brdf> create(const ParameterValues& p) const override {
    return makeGeometryBrdf([kd = p.values[0] / pi](const SurfaceGeometry&) { return kd; });
  }
};

}  // namespace

const Model& lambert() {
  static const Lambert model;
  return model;
}

}  // namespace gonio::models
