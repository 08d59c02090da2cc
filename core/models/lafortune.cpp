// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>

#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/direction_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/lafortune.glsl"
}
namespace ranges {
#include "core/models/lafortune.glsl"
}

namespace {

constexpr std::string_view lafortune1997 =
    "Lafortune et al. 1997, Non-Linear Approximation of Reflectance Functions, eq. 8";
constexpr std::string_view normalisations[] = {"ngan", "none"};

enum Index { diffuse, specular, cXY, cZ, exponent, normalisation };
/// Below it C_xy and C_z count as 0: there is no lobe.
constexpr double smallest = 1e-12;

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1, "k_s N (C_xy (i_x o_x + i_y o_y) + C_z i_z o_z)^n", lafortune1997),
    {.id = "c-xy", .label = "C xy", .symbol = "C_xy", .unit = "",
     .softMin = -1, .softMax = 1, .hardMin = -1, .hardMax = 1, .defaultValue = -0.577,
     .description = "Direction of the highlight: at -C_z the mirror direction; more negative values lean it towards "
                    "the horizon, positive values back towards the light.",
     .formula = "C_xy (i_x o_x + i_y o_y)", .reference = lafortune1997},
    {.id = "c-z", .label = "C z", .symbol = "C_z", .unit = "",
     .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 1, .defaultValue = 0.577,
     .description = "Weight of the z components: together with C xy, how far the highlight leans from the normal.",
     .formula = "C_z i_z o_z", .reference = lafortune1997},
    exponentParameter("(C_xy (i_x o_x + i_y o_y) + C_z i_z o_z)^n", lafortune1997),
    choiceParameter("normalisation", "Normalisation", "N",
                    "Scales the highlight with its sharpness; the common scale of C xy and C z then has no effect.",
                    "ngan: (n + 2) / (2 pi max(|C_xy|, C_z)^n); none: 1",
                    "Ngan et al. 2005, Experimental Analysis of BRDF Models", normalisations),
};

constexpr ModelSpec lafortuneSpec = {
    .id = "lafortune", .name = "Lafortune",
    .description = "One isotropic lobe of Lafortune's generalised cosine: Phong's lobe in a direction of its "
                   "own, off-specular or backward. Reciprocal. With the normalisation 'none' the albedo of the "
                   "highlight depends on the other parameters and exceeds 1 for broad lobes.",
    .formula = "k_d / pi + k_s N max(0, C_xy (i_x o_x + i_y o_y) + C_z i_z o_z)^n",
    .reference = lafortune1997, .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

struct Lobe {
  double n, largest, factor;

  explicit Lobe(const ParameterValues& p)
      : n(p.values[exponent].x), largest(std::max(std::abs(p.values[cXY].x), p.values[cZ].x)) {
    const bool normalised = chosen(p.values[normalisation].x) == 0;
    factor = normalised ? reflectionNormalisation(n) : std::exp(n * std::log(largest));
    if (!(largest > smallest)) factor = 0;
  }
};

auto arguments(const ParameterValues& p) {
  const Lobe lobe(p);
  const double xy = p.values[cXY].x, scale = std::max(lobe.largest, smallest);
  return std::tuple(p.values[diffuse] / pi, p.values[specular] * lobe.factor, std::abs(xy) / scale,
                    p.values[cZ].x / scale, xy > 0 ? -1.0 : 1.0, lobe.n);
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const Lobe lobe(p);
  const double xy = p.values[cXY].x,
               albedo = maxChannel(p.values[specular]) * lobe.factor / reflectionNormalisation(lobe.n);
  return makeGeometryBrdf(
      bound<glsl::formula_lafortune, ranges::formula_lafortune>(arguments(p)),
      diffuseMixture(maxChannel(p.values[diffuse]), albedo, CosinePowerDensity{lobe.n, {xy, xy, p.values[cZ].x}}));
}

}  // namespace

const Model& lafortune() {
  static const Model model(lafortuneSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
