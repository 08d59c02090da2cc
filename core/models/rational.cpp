// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>
#include <string_view>

#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"

namespace gonio::models {

namespace glsl {
#include "core/models/rational.glsl"
}
namespace ranges {
#include "core/models/rational.glsl"
}

namespace {

constexpr std::string_view pacanowski = "Pacanowski et al. 2012, Rational BRDF, eq. 1-3";
constexpr std::string_view formulaText =
    "(p_0 + p_x x + p_y y + p_xx x^2 + p_xy x y + p_yy y^2) / (1 + q_x x + q_y y + q_xx x^2 + q_xy x y + q_yy y^2), "
    "x = 1 - cos theta_h, y = 1 - cos theta_d";

// clang-format off
constexpr ParameterSpec numerator(std::string_view id, std::string_view label, std::string_view symbol, double highest,
                                  double defaultValue, std::string_view description) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "1/sr",
          .softMin = 0, .softMax = highest, .hardMin = 0, .hardMax = 1e12, .defaultValue = defaultValue,
          .group = ParameterGroup::coefficients, .perChannel = true, .linear = true,
          .description = description, .formula = formulaText, .reference = pacanowski};
}

constexpr ParameterSpec denominator(std::string_view id, std::string_view label, std::string_view symbol,
                                    double highest, double defaultValue, std::string_view description) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 1e-2, .softMax = highest, .hardMin = 1e-4, .hardMax = 1e16, .defaultValue = defaultValue,
          .scale = ParameterScale::logarithmic, .group = ParameterGroup::coefficients,
          .description = description, .formula = formulaText, .reference = pacanowski};
}

constexpr ParameterSpec parameters[] = {
    numerator("p-0", "Peak", "p_0", 10, 1, "Value of the highlight with light and viewer in the same direction."),
    numerator("p-x", "Diffuse", "p_x", 1000, 6,
              "Divided by Narrowness (q_x), it is the value just outside the highlight."),
    numerator("p-y", "Peak rise", "p_y", 10, 0, "How much the highlight increases towards grazing angles."),
    numerator("p-xx", "Diffuse tail", "p_xx", 1e5, 0,
              "Divided by Falloff (q_xx), it is the value far outside the highlight, where the falloff is 1/x^2."),
    numerator("p-xy", "Diffuse rise", "p_xy", 1000, 0,
              "How much the diffuse term increases towards grazing angles."),
    numerator("p-yy", "Peak rise, grazing", "p_yy", 100, 0,
              "How much the highlight increases very close to grazing incidence."),
    denominator("q-x", "Narrowness", "q_x", 1e6, 100, "Where the falloff of the highlight begins: large values are "
                                                      "glossy."),
    denominator("q-y", "Incidence falloff", "q_y", 10, 0.01, "How much all values decrease towards grazing angles."),
    denominator("q-xx", "Falloff", "q_xx", 1e10, 0.01,
                "Where the falloff of the highlight changes from 1/x to 1/x^2: the larger the value, the closer to the "
                "peak."),
    denominator("q-xy", "Narrowing", "q_xy", 1e6, 0.01, "How much the highlight narrows towards grazing angles."),
    denominator("q-yy", "Grazing falloff", "q_yy", 10, 0.01,
                "How much all values decrease very close to grazing incidence."),
};

constexpr ModelSpec rationalSpec = {
    .id = "rational", .name = "Rational function",
    .description = "A quotient of two polynomials of the half-difference angles. All coefficients are positive: the "
                   "part of the published family that has neither poles nor negative values. Reciprocal; nothing "
                   "bounds the energy.",
    .formula = formulaText, .reference = pacanowski, .parameters = parameters, .family = ModelFamily::series};
// clang-format on

/// Behind the numerator's coefficients of 1, x, y, x^2, x y and y^2 those of the denominator, without the first.
auto arguments(const ParameterValues& p) {
  const auto& v = p.values;
  return std::tuple(v[0], v[1], v[2], v[3], v[4], v[5], v[6].x, v[7].x, v[8].x, v[9].x, v[10].x);
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  /// At theta_d = 0.
  const auto valueAt = [&](double x) {
    return luminance(std::apply([x](const auto&... each) { return glsl::rationalValue(x, 0, each...); }, arguments(p)));
  };
  const double body = valueAt(0.5);
  return makeGeometryBrdf(bound<glsl::formula_rational, ranges::formula_rational>(arguments(p)),
                          excessSampler(pi * body, [&](double thetaH) {
                            const double s = std::sin(thetaH / 2);
                            return valueAt(2 * s * s) - body;
                          }));
}

}  // namespace

const Model& rational() {
  static const Model model(rationalSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
