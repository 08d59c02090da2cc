// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/brdf/data_transform.h"

namespace gonio {

/// Added to both sides of the ratio, so that black cells have a logarithm.
inline constexpr double logRelativeEpsilon = 1e-3;

/// The log-relative mapping of one cell (Nielsen et al. 2015, "On Optimal, Minimal BRDF Sampling for Reflectance
/// Acquisition"; dissertation eq. 5.7):
///   y = ln((rho w + e) / (reference + e)),  w = cosineWeight() of the pair, e = 1e-3.
/// Without cancellation: about the reference, where y is exactly 0, by ln(1 + x), far below it by the ratio itself.
/// @param rho 1/sr, >= 0; @param reference of rho w, >= 0.
inline double logRelative(double rho, double weight, double reference) {
  const double weighted = rho * weight, excess = (weighted - reference) / (reference + logRelativeEpsilon);
  return excess > -0.5 ? std::log1p(excess)
                       : std::log((weighted + logRelativeEpsilon) / (reference + logRelativeEpsilon));
}
/// The reflectance again, 1/sr, in [0, largestReflectance]; 0 where y is not a number.
inline double inverseLogRelative(double y, double weight, double reference) {
  const double scale = reference + logRelativeEpsilon;
  const double weighted = y > -0.5 ? reference + scale * std::expm1(y) : scale * std::exp(y) - logRelativeEpsilon;
  return weighted > 0 ? std::min(weighted / weight, largestReflectance) : 0;
}

/// Of values none of which is NaN, the middle one, or the mean of the two in the middle; 0 of none. Reorders them.
float medianOf(std::span<float> values);

/// The reference of a set of materials: for each cell the median over all columns.
/// @param columns rho w >= 0, each of as many cells; @return as many values. In parallel, deterministic.
std::vector<float> medianReference(std::span<const std::span<const float>> columns);

}  // namespace gonio
