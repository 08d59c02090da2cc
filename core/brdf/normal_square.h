// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/coordinates/half_difference.h"

/// The unit square of half vectors (microfacet normals) in which densities of reflected directions are tabulated: x =
/// sqrt(2 theta / pi), which resolves the highlight finely; y = (phi + pi) / (2 pi). Dupuy and Jakob 2018, section 4.
namespace gonio {

/// @param polar, azimuth of a half vector, rad.
inline glm::dvec2 toNormalSquare(double polar, double azimuth) {
  const double y = (azimuth + pi) / (2 * pi);
  return {std::sqrt(polar * (2 / pi)), y - std::floor(y)};
}
/// @param half any length. @param turn azimuth that is subtracted, rad.
inline glm::dvec2 toNormalSquare(const Direction& half, double turn) {
  return toNormalSquare(polarAngle(half), azimuth(half) - turn);
}

inline Direction fromNormalSquare(const glm::dvec2& square, double turn) {
  return fromSpherical(square.x * square.x * halfPi, 2 * pi * square.y - pi + turn);
}

/// Whether the sum of two unit vectors defines a half vector above the horizon.
inline bool isHalfVector(const Direction& sum) { return sum.z > 0 && glm::dot(sum, sum) > minSquaredHalfLength; }

/// The direction reflected about a normal; the zero vector if it is behind the microfacet (w . normal <= 0).
inline Direction reflected(const Direction& w, const Direction& normal) {
  const double cosine = glm::dot(w, normal);
  return cosine > 0 ? 2 * cosine * normal - w : Direction(0);
}

/// Area of the square per solid angle of reflected directions, 1/sr. @param sum of the two directions. @param w either
/// of them.
inline double squarePerSolidAngle(const glm::dvec2& square, const Direction& sum, const Direction& w) {
  // The stretch vanishes within a few nanoradians of the pole, where nothing is sampled.
  constexpr double minStretch = 1e-12;
  const double length = glm::length(sum);
  const double sinTheta = std::sqrt(sum.x * sum.x + sum.y * sum.y) / length;
  const double stretch = 2 * pi * pi * square.x * sinTheta;
  const double cosD = std::abs(glm::dot(sum, w)) / length;
  return 1 / (std::max(stretch, minStretch) * 4 * std::max(cosD, minStretch));
}

}  // namespace gonio
