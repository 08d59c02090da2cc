// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/math/fast_functions.h"
#include "core/models/common_parameters.h"

/// Common parts of the two ABC models: Löw, Kronander, Ynnerman and Unger 2012, "BRDF Models for Accurate and Efficient
/// Rendering of Glossy Surfaces", based on Church's power spectrum of polished surfaces.
namespace gonio::models {

inline constexpr std::string_view abcReference =
    "Löw, Kronander, Ynnerman and Unger 2012, BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces";

/// (1 + B x)^-C, x >= 0; finite for large B.
inline double abcLobe(double x, double b, double c) { return fastExp(-c * fastLog1p(b * x)); }

/// The integral of abcLobe() over x in [0, 1].
inline double abcLobeIntegral(double b, double c) {
  const double end = std::log1p(b), e = 1 - c;
  return std::abs(e) * end < 1e-9 ? end / b : std::expm1(e * end) / (e * b);
}

// clang-format off
// The hard ranges include all published fits of the 100 MERL materials (A up to 5710, B up to 8.1e6, C 0.014 to 2.7).
constexpr ParameterSpec abcAmplitudeParameter(std::string_view formula) {
  return {.id = "a", .label = "Amplitude", .symbol = "A", .unit = "",
          .softMin = 0, .softMax = 1000, .hardMin = 0, .hardMax = 1e6, .defaultValue = 50,
          .perChannel = true, .linear = true,
          .description = "Strength and tint of the highlight, which is not normalised: raise it as the highlight "
                         "narrows.",
          .formula = formula, .reference = abcReference, .role = ParameterRole::peak};
}
constexpr ParameterSpec abcNarrownessParameter(std::string_view formula) {
  return {.id = "b", .label = "Narrowness", .symbol = "B", .unit = "",
          .softMin = 10, .softMax = 1e6, .hardMin = 1e-3, .hardMax = 1e9, .defaultValue = 1000,
          .scale = ParameterScale::logarithmic,
          .description = "Where the falloff of the highlight begins: large values are glossy.",
          .formula = formula, .reference = abcReference, .role = ParameterRole::sharpness};
}
constexpr ParameterSpec abcFalloffParameter(std::string_view formula) {
  return {.id = "c", .label = "Falloff", .symbol = "C", .unit = "",
          .softMin = 0.1, .softMax = 3, .hardMin = 0, .hardMax = 20, .defaultValue = 1,
          .description = "How fast the highlight falls off beyond its core: small values leave a wide haze.",
          .formula = formula, .reference = abcReference};
}
// clang-format on

}  // namespace gonio::models
