// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <random>

#include "core/acquisition/factor_plan.h"
#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_out.h"
#include "core/coordinates/projected_deviation.h"
#include "tests/support/function_brdf.h"

namespace gonio::test {

/// The axes of products of two curves; the others follow.
inline constexpr int productAxes = int(acquisition::FactorAxes::adaptive);

/// (angle, distance) of a pair, computed again for the tests.
inline glm::dvec2 factorPlaceOf(acquisition::FactorAxes axes, const Direction& wi, const Direction& wo) {
  using acquisition::FactorAxes;
  const ProjectedDeviation projected = toProjectedDeviation(wi, wo);
  const HalfOut half = toHalfOut(wi, wo);
  if (axes == FactorAxes::projectedDeviation) return {projected.thetaR, projected.deviation};
  if (axes == FactorAxes::symmetricDeviation || axes == FactorAxes::adaptive)
    return {toHalfDifference(wi, wo).thetaD, projected.deviation};
  return {axes == FactorAxes::halfOut ? half.thetaO : toHalfDifference(wi, wo).thetaD, half.thetaH};
}

/// z = (1 + angle) / (1 + 2 distance) in red, 0.3 / (1 + distance) in green: products of two curves. Black in blue.
inline FunctionBrdf productOfCurves(acquisition::FactorAxes axes) {
  return FunctionBrdf([axes](const Direction& wi, const Direction& wo) {
    const glm::dvec2 at = factorPlaceOf(axes, wi, wo);
    return Rgb(std::expm1((1 + at.x) / (1 + 2 * at.y)), std::expm1(0.3 / (1 + at.y)), 0);
  });
}

/// Any pair of directions within 86 degrees of the normal.
inline DirectionPair factorPair(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double a = uniform(random), b = uniform(random), c = uniform(random), d = uniform(random);
  return {fromSpherical(1.5 * a, 6 * b), fromSpherical(1.5 * c, 6 * d)};
}

}  // namespace gonio::test
