// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/direction_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/edwards_disk.glsl"
}
namespace ranges {
/// gonio::squaredRimFraction() on both sides of the mirror direction.
REAL squaredRimFraction(const vec2& deviation, const vec3& wo) {
  const REAL squared = dot(deviation, deviation), along = deviation.x * wo.x + deviation.y * wo.y;
  const REAL root = sqrt(square(along) + square(wo.z) * squared);
  const REAL outward = squared / (max(along, REAL(0)) + root), inward = (root - min(along, REAL(0))) / square(wo.z);
  const REAL fraction = along.low >= 0 ? outward : along.high <= 0 ? inward : hull(outward, inward);
  return min(square(max(REAL(0), REAL(squared.low > 0 ? fraction.low : 0, fraction.high))), REAL(1));
}
#include "core/models/edwards_disk.glsl"
}  // namespace ranges

namespace {

constexpr std::string_view edwards2006 =
    "Edwards et al. 2006, The Halfway Vector Disk for BRDF Modeling (this distribution derived here)";

enum Index { diffuse, specular, exponent };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1, "k_s (n + 1) / pi (1 - u^2)^n, u = |Dp| / L", edwards2006),
    exponentParameter("(1 - u^2)^n, u = |Dp| / L", edwards2006),
};

constexpr ModelSpec edwardsDiskSpec = {
    .id = "edwards-disk", .name = "Edwards halfway disk",
    .description = "A highlight on the disk of projected halfway vectors, from the mirror point to the rim: its "
                   "albedo is exactly k_s at every angle; with an exponent of 0 it is Lambertian. Not reciprocal: "
                   "the distance to the rim is measured from the viewer's mirror point.",
    .formula = "k_d / pi + k_s (n + 1) / pi (1 - |Dp|^2 / L^2)^n, Dp = i_xy + o_xy, "
               "L the distance from the mirror point -o_xy to the rim along Dp",
    .reference = edwards2006, .parameters = parameters,
    .family = ModelFamily::empirical,
    .reciprocal = false, .conservesEnergy = true};
// clang-format on

auto arguments(const ParameterValues& p) {
  const double n = p.values[exponent].x;
  return std::tuple(p.values[diffuse] / pi, p.values[specular] * ((n + 1) / pi), n);
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  return makeGeometryBrdf(bound<glsl::formula_edwards_disk, ranges::formula_edwards_disk>(arguments(p)),
                          diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]),
                                         RimPowerDensity{p.values[exponent].x}),
                          true, edwardsDiskSpec.reciprocal);
}

}  // namespace

const Model& edwardsDisk() {
  static const Model model(edwardsDiskSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
