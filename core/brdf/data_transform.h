// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace gonio {

/// What factorisations make of a reflectance before they work on it, so that a highlight does not drown the rest
/// (dissertation 2.4).
enum class DataTransform {
  logPlus,    ///< y = ln(1 + rho): eq. 2.29, 4.26
  cosineLog,  ///< y = ln(1 + rho w), w = max(cos theta_i cos theta_o, 1e-3): eq. 2.30, 4.34
  root,       ///< y = rho^(1/2): eq. 2.31 with gamma 2
  none        ///< y = rho
};
/// In JSON, in files and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> dataTransformNames{"log-plus", "cosine-log", "root", "none"};

/// w of the cosine-weighted logarithm: floored, since its inverse divides by it.
inline double cosineWeight(double cosI, double cosO) { return std::max(cosI * cosO, 1e-3); }

/// @param rho 1/sr, >= 0; @param weight cosineWeight() of the pair. Without cancellation at any size.
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

/// d rho / d y, by which a small error of y is one of the reflectance; at least 0.01, where that of the root vanishes.
/// @param rho 1/sr, >= 0; @param weight cosineWeight() of the pair.
inline double reflectanceSlope(DataTransform transform, double rho, double weight) {
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

/// What inverses give at most, 1/sr: beyond y = 89 a logarithm's inverse leaves the range of the tables' floats.
/// Whoever fills a table with inverses counts those that reach it.
inline constexpr double largestReflectance = std::numeric_limits<float>::max();

/// The reflectance again, 1/sr, in [0, largestReflectance]; values of y that no reflectance has give 0.
inline double inverseTransformed(DataTransform transform, double y, double weight) {
  if (!(y > 0)) return 0;
  switch (transform) {
    case DataTransform::logPlus:
      return std::min(std::expm1(y), largestReflectance);
    case DataTransform::cosineLog:
      return std::min(std::expm1(y) / weight, largestReflectance);
    case DataTransform::root:
      return std::min(y * y, largestReflectance);
    default:
      return std::min(y, largestReflectance);
  }
}

/// y = rho^(1/gamma), gamma in [1, 3] (eq. 2.31 with the factor 1): what reconstructions are compared in. Negative
/// values, which a reconstruction may have, count as 0.
inline double gammaTransformed(double rho, double gamma) {
  if (!(rho > 0)) return 0;
  return gamma == 2 ? std::sqrt(rho) : std::pow(rho, 1 / gamma);
}

}  // namespace gonio
