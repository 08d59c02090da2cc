// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/math/fast_functions.h"
#include "core/models/common_parameters.h"
#include "core/models/surface_geometry.h"

/// Powers of the cosine of the angle between light and mirror direction (Phong), or between half vector and normal
/// (Blinn). Near 1 the cosine is computed from the distance between the directions, so that exponents of a million are
/// accurate.
namespace gonio::models {

// clang-format off
/// Exponent of a cosine lobe; up to 6.3e5 in published fits of measured materials.
constexpr ParameterSpec exponentParameter(std::string_view formula, std::string_view reference) {
  return {.id = "exponent", .label = "Shininess", .symbol = "n", .unit = "",
          .softMin = 1, .softMax = 1e4, .hardMin = 1e-6, .hardMax = 1e6, .defaultValue = 50,
          .scale = ParameterScale::logarithmic,
          .description = "Sharpness of the highlight: large values are glossy.",
          .formula = formula, .reference = reference, .role = ParameterRole::sharpness};
}
// clang-format on

/// (1 - x)^n for x >= 0; 0 beyond 1.
inline double powerOfComplement(double x, double n) { return x < 1 ? fastExp(n * fastLog1p(-x)) : 0; }

/// max(0, cos alpha)^n, alpha the angle between wi and the mirror direction of wo. O(1).
inline double reflectionPower(const SurfaceGeometry& g, double n) {
  const Direction apart(g.wi.x + g.wo.x, g.wi.y + g.wo.y, g.wi.z - g.wo.z);
  return powerOfComplement(glm::dot(apart, apart) / 2, n);
}

/// cos^n theta_h; also accurate for nearly horizontal half vectors. O(1).
/// ln cos theta_h: the correction is for the rounding of half.z, which matters near the normal.
inline double logCosH(const SurfaceGeometry& g) {
  const double correction = ((1 - g.half.z) - g.oneMinusCosH) / g.half.z;
  return logWithCorrection(g.half.z, g.oneMinusCosH < 0.5 ? correction : 0.0);
}
inline double halfVectorPower(const SurfaceGeometry& g, double n) { return fastExp(n * logCosH(g)); }

/// Normalisation factor of cos^n theta_h, 1/sr: its directional albedo becomes 1 at normal incidence, where it is
/// largest.
inline double halfVectorNormalisation(double n) { return (n + 2) * (n + 4) / (8 * pi * (n + std::exp2(-n / 2))); }
/// The same for cos^n alpha.
inline double reflectionNormalisation(double n) { return (n + 2) / (2 * pi); }

}  // namespace gonio::models
