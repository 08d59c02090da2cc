// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/brdf/data_transform.h"

namespace gonio {

/// e of logRelative(): added to numerator and denominator of the ratio, so that the logarithm of black cells is finite.
/// In metrics also the lower bound of the product of cosines.
inline constexpr double logRelativeOffset = 1e-3;

/// The log-relative mapping of one cell (Nielsen et al. 2015, "On Optimal, Minimal BRDF Sampling for Reflectance
/// Acquisition"; Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", eq.
/// 5.7):
///   y = ln((rho w + e) / (reference + e)), w = cosineWeight() of the pair, e = 1e-3.
/// Free of cancellation; exactly 0 at the reference. @param rho 1/sr, >= 0. @param reference of rho w, >= 0, 1/sr.
inline double logRelative(double rho, double weight, double reference) {
  const double weighted = rho * weight, excess = (weighted - reference) / (reference + logRelativeOffset);
  return excess > -0.5 ? std::log1p(excess)
                       : std::log((weighted + logRelativeOffset) / (reference + logRelativeOffset));
}
/// Inverse of logRelative(): the BRDF value, 1/sr, in [0, maxBrdfValue]; 0 if y is NaN.
inline double inverseLogRelative(double y, double weight, double reference) {
  const double scale = reference + logRelativeOffset;
  const double weighted = y > -0.5 ? reference + scale * std::expm1(y) : scale * std::exp(y) - logRelativeOffset;
  return weighted > 0 ? std::min(weighted / weight, maxBrdfValue) : 0;
}

/// The median of values without NaN (the mean of the two middle ones for an even number); 0 for no values. Reorders
/// them.
float medianOf(std::span<float> values);

/// The reference of a set of materials: per cell the median over all columns. @param columns rho w >= 0, all of the
/// same number of cells. @return one value per cell. Parallel, deterministic.
std::vector<float> medianReference(std::span<const std::span<const float>> columns);

}  // namespace gonio
