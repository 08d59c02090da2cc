// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"

namespace gonio::models {

namespace glsl {
// Mesa's compiler miscounts the arguments of a function with a parameter that has no name.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "core/models/lambert.glsl"
}  // namespace glsl
namespace ranges {
#include "core/models/lambert.glsl"
}
#pragma GCC diagnostic pop

namespace {

// clang-format off
constexpr ParameterSpec parameters[] = {diffuseParameter(0.5)};

constexpr ModelSpec lambertSpec = {
    .id = "lambert", .name = "Lambert",
    .description = "The ideal matte surface: equally bright from every direction. Reciprocal; albedo exactly k_d.",
    .formula = "k_d / pi", .reference = "Lambert 1760, Photometria", .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

auto arguments(const ParameterValues& p) { return std::tuple(p.values[0] / pi); }

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  return makeGeometryBrdf(bound<glsl::formula_lambert, ranges::formula_lambert>(arguments(p)));
}

}  // namespace

const Model& lambert() {
  static const Model model(lambertSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
