// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/fast_functions.h"

namespace gonio {

/// Transforms of BRDF values before a factorisation, so that highlights do not dominate the error (Tongbuasirilai 2023,
/// "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", section 2.4).
enum class DataTransform {
  logPlus,           ///< y = ln(1 + rho / e), e = 1 1/sr: eq. 2.29, 4.26
  cosineLog,         ///< y = ln(1 + rho w), w = max(cos theta_i cos theta_o, 1e-3): eq. 2.30, 4.34
  root,              ///< y = rho^(1/gamma), gamma = 2: eq. 2.31
  none,              ///< y = rho: gamma = 1
  logPlusTenth,      ///< as logPlus with e = 0.1: dark values weigh more
  logPlusHundredth,  ///< as logPlus with e = 0.01
  gamma15,           ///< as root with gamma = 1.5
  gamma25,           ///< gamma = 2.5
  gamma3             ///< gamma = 3
};
/// Names in JSON, in files and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 9> dataTransformNames{
    "log-plus", "cosine-log", "root", "none", "log-plus-0.1", "log-plus-0.01", "gamma-1.5", "gamma-2.5", "gamma-3"};

/// nullopt for a name that is none of them.
inline std::optional<DataTransform> dataTransformNamed(std::string_view name) {
  const auto found = std::ranges::find(dataTransformNames, name);
  if (found == dataTransformNames.end()) return std::nullopt;
  return DataTransform(found - dataTransformNames.begin());
}
/// The names, separated by commas, for messages.
inline std::string dataTransformList() {
  std::string list;
  for (const std::string_view name : dataTransformNames) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

// Arrays, not switches: GCC 12 makes a table of a switch's results and reads it before it asks whether there is one.
/// e of the logarithms, 1/sr; 0 for the others.
constexpr double logOffset(DataTransform transform) {
  constexpr std::array<double, dataTransformNames.size()> offsets{1, 1, 0, 0, 0.1, 0.01};
  return offsets[static_cast<std::size_t>(transform)];
}
/// gamma of the roots; 1 for `none` and the logarithms.
constexpr double gammaOf(DataTransform transform) {
  constexpr std::array<double, dataTransformNames.size()> gammas{1, 1, 2, 1, 1, 1, 1.5, 2.5, 3};
  return gammas[static_cast<std::size_t>(transform)];
}

/// w of the cosine-weighted logarithm. It has a lower bound because the inverse divides by it.
inline double cosineWeight(double cosI, double cosO) { return std::max(cosI * cosO, 1e-3); }

/// y of a BRDF value, without cancellation. @param rho 1/sr, >= 0. @param weight cosineWeight() of the pair.
inline double transformed(DataTransform transform, double rho, double weight) {
  if (transform == DataTransform::cosineLog) return std::log1p(rho * weight);
  if (const double offset = logOffset(transform); offset > 0) return std::log1p(rho / offset);
  if (transform == DataTransform::root) return std::sqrt(rho);
  return transform == DataTransform::none ? rho : std::pow(rho, 1 / gammaOf(transform));
}

/// d rho / d y: the factor from a small error of y to the error of the BRDF value. That of roots, which vanishes at 0,
/// is at least 0.01. @param rho 1/sr, >= 0. @param weight cosineWeight() of the pair.
inline double inverseSlope(DataTransform transform, double rho, double weight) {
  if (transform == DataTransform::cosineLog) return rho + 1 / weight;
  if (const double offset = logOffset(transform); offset > 0) return offset + rho;
  if (transform == DataTransform::none) return 1;
  const double gamma = gammaOf(transform);
  return std::max(gamma * std::pow(rho, 1 - 1 / gamma), 0.01);
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
    case DataTransform::logPlusTenth:
    case DataTransform::logPlusHundredth:
      return std::min(logOffset(transform) * fastExpm1(std::min(positive, maxLog)), maxBrdfValue);
    case DataTransform::cosineLog:
      return std::min(fastExpm1(std::min(positive, maxLog)) / weight, maxBrdfValue);
    case DataTransform::root:
      return std::min(positive * positive, maxBrdfValue);
    case DataTransform::gamma15:
      return std::min(positive * std::sqrt(positive), maxBrdfValue);
    case DataTransform::gamma25:
      return std::min(positive * positive * std::sqrt(positive), maxBrdfValue);
    case DataTransform::gamma3:
      return std::min(positive * positive * positive, maxBrdfValue);
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
