// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"

namespace gonio::models {

namespace glsl {
#include "core/models/oren_nayar.glsl"
}
namespace ranges {
#include "core/models/oren_nayar.glsl"
}

namespace {

constexpr std::string_view orenNayar1994 = "Oren and Nayar 1994, Generalization of Lambert's Reflectance Model, eq. 30";

enum Index { diffuse, slope };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.5),
    {.id = "roughness", .label = "Roughness", .symbol = "sigma", .unit = "rad",
     .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = halfPi, .defaultValue = 0.5,
     .scale = ParameterScale::angle, .group = ParameterGroup::diffuse,
     .description = "How far the matte facets tilt: rough surfaces look flat, like the full moon; 0 is Lambert.",
     .formula = "A = 1 - sigma^2 / (2 (sigma^2 + 0.33)), B = 0.45 sigma^2 / (sigma^2 + 0.09)",
     .reference = orenNayar1994, .role = ParameterRole::width},
};

constexpr ModelSpec orenNayarSpec = {
    .id = "oren-nayar", .name = "Oren-Nayar",
    .description = "A matte surface of V-cavities with matte walls, in the qualitative form; brighter towards the "
                   "light than Lambert. Reciprocal; gains up to 1.5 % of energy at grazing angles where sigma is about "
                   "0.2.",
    .formula = "k_d / pi (A + B max(0, cos(phi_i - phi_o)) sin(max(theta_i, theta_o)) tan(min(theta_i, theta_o)))",
    .reference = orenNayar1994, .parameters = parameters};
// clang-format on

auto arguments(const ParameterValues& p) {
  const double sigma2 = p.values[slope].x * p.values[slope].x;
  const double a = 1 - 0.5 * sigma2 / (sigma2 + 0.33), b = 0.45 * sigma2 / (sigma2 + 0.09);
  const Rgb kd = p.values[diffuse] / pi;
  return std::tuple(a * kd, b * kd);
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  return makeGeometryBrdf(bound<glsl::formula_oren_nayar, ranges::formula_oren_nayar>(arguments(p)));
}

}  // namespace

const Model& orenNayar() {
  static const Model model(orenNayarSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
