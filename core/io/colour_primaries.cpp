// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/colour_primaries.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "core/math/colour.h"
#include "core/support/text.h"

namespace gonio::io {

namespace {

bool areClose(const ColourPrimaries& a, const ColourPrimaries& b, double tolerance) {
  const auto distance = [](const glm::dvec2& p, const glm::dvec2& q) {
    return std::max(std::abs(p.x - q.x), std::abs(p.y - q.y));
  };
  return distance(a.red, b.red) <= tolerance && distance(a.green, b.green) <= tolerance &&
         distance(a.blue, b.blue) <= tolerance && distance(a.white, b.white) <= tolerance;
}

/// The sum of the three is 1.
glm::dvec3 xyzOf(const glm::dvec2& xy) { return {xy.x, xy.y, 1 - xy.x - xy.y}; }

/// X, Y, Z of the white at Y = 1.
glm::dvec3 whiteOf(const ColourPrimaries& primaries) { return xyzOf(primaries.white) / primaries.white.y; }

/// RGB to XYZ, with white at Y = 1 (SMPTE RP 177).
glm::dmat3 toXyz(const ColourPrimaries& primaries) {
  const glm::dmat3 axes(xyzOf(primaries.red), xyzOf(primaries.green), xyzOf(primaries.blue));
  const glm::dvec3 scale = glm::inverse(axes) * whiteOf(primaries);
  return {scale.x * axes[0], scale.y * axes[1], scale.z * axes[2]};
}

/// XYZ under a white to XYZ under another one.
glm::dmat3 adaptation(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dmat3 cones =
      glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const glm::dvec3 ratio = (cones * to) / (cones * from);
  return glm::inverse(cones) * glm::dmat3(ratio.x, 0, 0, 0, ratio.y, 0, 0, 0, ratio.z) * cones;
}

}  // namespace

bool ColourPrimaries::areSrgb() const { return areClose(*this, {}, 0.002); }

bool ColourPrimaries::areXyz() const { return areClose(*this, {{1, 0}, {0, 1}, {0, 0}, white}, 1e-4); }

std::string ColourPrimaries::text() const {
  const auto pair = [](const glm::dvec2& xy) {
    return " (" + numberText(float(xy.x)) + ", " + numberText(float(xy.y)) + ")";
  };
  return "red" + pair(red) + ", green" + pair(green) + ", blue" + pair(blue) + ", white" + pair(white);
}

std::optional<glm::dmat3> toSrgbMatrix(const ColourPrimaries& primaries) {
  if (primaries.areXyz()) return glm::dmat3(linearSrgb({1, 0, 0}), linearSrgb({0, 1, 0}), linearSrgb({0, 0, 1}));
  const glm::dmat3 axes(xyzOf(primaries.red), xyzOf(primaries.green), xyzOf(primaries.blue));
  if (!(std::abs(glm::determinant(axes)) > 1e-4) || !(primaries.white.y > 1e-3)) return std::nullopt;
  const ColourPrimaries srgb;
  const glm::dmat3 matrix =
      glm::inverse(toXyz(srgb)) * adaptation(whiteOf(primaries), whiteOf(srgb)) * toXyz(primaries);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (!(std::abs(matrix[column][row]) < 1e3)) return std::nullopt;
  return matrix;
}

}  // namespace gonio::io
