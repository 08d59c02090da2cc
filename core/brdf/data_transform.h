// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "core/math/fast_functions.h"

namespace gonio {

/// Transforms of BRDF values before a factorisation, so that highlights do not dominate the error (Tongbuasirilai 2023,
/// "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", section 2.4).
enum class DataTransform {
  logPlus,    ///< y = ln(1 + rho): eq. 2.29, 4.26
  cosineLog,  ///< y = ln(1 + rho w), w = max(cos theta_i cos theta_o, 1e-3): eq. 2.30, 4.34
  root,       ///< y = rho^(1/2): eq. 2.31 with gamma 2
  none        ///< y = rho
};
/// Names in JSON, in files and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> dataTransformNames{"log-plus", "cosine-log", "root", "none"};

/// w of the cosine-weighted logarithm. It has a lower bound because the inverse divides by it.
inline double cosineWeight(double cosI, double cosO) { return std::max(cosI * cosO, 1e-3); }

/// y of a BRDF value, without cancellation. @param rho 1/sr, >= 0. @param weight cosineWeight() of the pair.
inline double transformed(DataTransform transform, double rho, double weight) {
  switch (transform) {
    case DataTransform::logPlus:
      return std::log1p(rho);
    case DataTransform::cosineLog:
      return std::log1p(rho * weight);
    case DataTransform::root:
      return std::sqrt(rho);
    default:
      return rho;
  }
}

/// d rho / d y: the factor from a small error of y to the error of the BRDF value. That of the root, which vanishes at
/// 0, is at least 0.01. @param rho 1/sr, >= 0. @param weight cosineWeight() of the pair.
inline double inverseSlope(DataTransform transform, double rho, double weight) {
  switch (transform) {
    case DataTransform::logPlus:
      return 1 + rho;
    case DataTransform::cosineLog:
      return rho + 1 / weight;
    case DataTransform::root:
      return std::max(2 * std::sqrt(rho), 0.01);
    default:
      return 1;
  }
}

/// Upper bound of the inverse transforms, 1/sr: beyond y = 89 the inverse of a logarithm exceeds the range of the
/// tables' floats. Code that fills a table with inverses counts the values that reach the bound.
inline constexpr double maxBrdfValue = std::numeric_limits<float>::max();

/// Inverse of transformed(): the BRDF value, 1/sr, in [0, maxBrdfValue]; 0 for y <= 0 or NaN.
inline double inverseTransformed(DataTransform transform, double y, double weight) {
  constexpr double maxLog = 700;  // e^700 is above maxBrdfValue
  const double positive = y > 0 ? y : 0;
  switch (transform) {
    case DataTransform::logPlus:
      return std::min(fastExpm1(std::min(positive, maxLog)), maxBrdfValue);
    case DataTransform::cosineLog:
      return std::min(fastExpm1(std::min(positive, maxLog)) / weight, maxBrdfValue);
    case DataTransform::root:
      return std::min(positive * positive, maxBrdfValue);
    default:
      return std::min(positive, maxBrdfValue);
  }
}

/// Both continued to negative values as odd functions. Measurements have such values for colours outside sRGB
/// (RglBrdf).
inline double transformedSigned(DataTransform transform, double rho, double weight) {
  return rho < 0 ? -transformed(transform, -rho, weight) : transformed(transform, rho, weight);
}
inline double inverseTransformedSigned(DataTransform transform, double y, double weight) {
  return y < 0 ? -inverseTransformed(transform, -y, weight) : inverseTransformed(transform, y, weight);
}

/// y = rho^(1/gamma), gamma in [1, 3] (eq. 2.31 with the factor 1), in which reconstructions are compared. Negative
/// values, which a reconstruction may contain, count as 0.
inline double gammaTransformed(double rho, double gamma) {
  if (!(rho > 0)) return 0;
  return gamma == 2 ? std::sqrt(rho) : std::pow(rho, 1 / gamma);
}

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
