// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/fast_atan2.h"
#include "core/math/types.h"

/// The unit square of half vectors of core/brdf/tabulated_lobe.h: x = tan(theta/2)^(1/4), which resolves mirror-like
/// highlights without trigonometric functions; y = (phi + pi) / (2 pi), with phi the azimuth relative to the viewer's.
/// The same functions in GLSL: shaders/preview/sampling_lobe.glsl.
namespace gonio {

/// The horizontal direction of azimuth 0: the viewer's, or the x axis for a viewer at the normal.
inline glm::dvec2 lobeAxis(const Direction& wo) {
  const double length = std::sqrt(wo.x * wo.x + wo.y * wo.y);
  return length > 0 ? glm::dvec2(wo.x, wo.y) / length : glm::dvec2(1, 0);
}

/// @param half unit vector, z >= 0.
inline glm::dvec2 toLobeSquare(const Direction& half, const glm::dvec2& axis) {
  const double tangent = std::sqrt(half.x * half.x + half.y * half.y) / (1 + half.z);
  const double phi = fastAtan2(axis.x * half.y - axis.y * half.x, axis.x * half.x + axis.y * half.y);
  return {std::sqrt(std::sqrt(tangent)), (phi + pi) / (2 * pi)};
}

inline Direction fromLobeSquare(const glm::dvec2& square, const glm::dvec2& axis) {
  const double squared = square.x * square.x, t = squared * squared, scale = 1 / (1 + t * t);
  const double phi = 2 * pi * square.y - pi, c = std::cos(phi), s = std::sin(phi), sine = 2 * t * scale;
  return {sine * (axis.x * c - axis.y * s), sine * (axis.y * c + axis.x * s), (1 - t * t) * scale};
}

/// Area of the square per solid angle of reflected directions, 1/sr. @param x of the square. @param cosD cosine of the
/// angle between the half vector and either direction.
inline double lobeSquarePerSolidAngle(double x, double cosD) {
  // The stretch falls below this bound only within about 1e-18 rad of the pole, where nothing is sampled.
  constexpr double minStretch = 1e-30;
  const double x2 = x * x, x4 = x2 * x2, one = 1 + x4 * x4;
  const double stretch = 32 * pi * x4 * x2 * x / (one * one);
  return 1 / (std::max(stretch, minStretch) * 4 * std::max(cosD, 1e-12));
}

}  // namespace gonio
