// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

namespace gonio::io {

/// Primaries and white of an RGB colour space, in CIE 1931 xy.
struct ColourPrimaries {
  glm::dvec2 red{0.64, 0.33}, green{0.3, 0.6}, blue{0.15, 0.06}, white{0.3127, 0.329};

  /// Whether they are those of sRGB (ITU-R BT.709), within 0.002.
  bool areSrgb() const;
  /// Whether the primaries are the axes of CIE XYZ, so that the three channels are X, Y and Z.
  bool areXyz() const;
  /// "red (0.64, 0.33), green (0.3, 0.6), blue (0.15, 0.06), white (0.3127, 0.329)".
  std::string text() const;
};

/// The matrix that converts linear colours of these primaries to linear sRGB. White remains white (1, 1, 1): the
/// Bradford transform (Lam 1985; Lindbloom, "Chromatic Adaptation") adapts it to D65. X, Y, Z are not adapted: white is
/// there what the values say. Empty if the primaries are not three different colours, or the white is black.
std::optional<glm::dmat3> toSrgbMatrix(const ColourPrimaries& primaries);

}  // namespace gonio::io
