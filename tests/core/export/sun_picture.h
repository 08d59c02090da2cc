// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QVector>
#include <cmath>
#include <limits>
#include <optional>

#include "core/brdf/brdf.h"

/// A picture that every renderer can make: the unit sphere by an orthographic camera that looks along -z and shows
/// [-1, 1]^2, in the light of a sun of irradiance pi to the right of the viewer.
namespace gonio::test {

inline constexpr int sunPictureSide = 128;
inline constexpr double sunAngle = 0.7;  // rad, of the sun to the view

/// The axis about which tangents run, right-handed: that of the view, or up.
enum class TangentAxis { view, up };

/// The mean of f cos theta_i pi over a pixel of the sphere, row 0 the bottom; nothing where the pixel is not all of
/// directions that are at least 20 degrees above the horizon, of the viewer and of the light.
inline std::optional<Rgb> sunPixel(const Brdf& brdf, int column, int row, TangentAxis axis) {
  constexpr int cells = 6, side = sunPictureSide;
  const Direction sun(std::sin(sunAngle), 0, std::cos(sunAngle));
  Rgb sum(0);
  for (int i = 0; i < cells * cells; ++i) {
    const double x = 2 * (column + (i % cells + 0.5) / cells) / side - 1;
    const double y = 2 * (row + (i / cells + 0.5) / cells) / side - 1;
    const double z2 = 1 - x * x - y * y;
    if (z2 < 0.1) return std::nullopt;
    const Direction normal(x, y, std::sqrt(z2));
    if (glm::dot(normal, sun) < 0.34) return std::nullopt;
    const Direction turning = axis == TangentAxis::view ? Direction(-y, x, 0) : Direction(normal.z, 0, -x);
    const Direction across = glm::normalize(turning), along = glm::cross(normal, across);
    const auto local = [&](const Direction& w) {
      return Direction(glm::dot(w, across), glm::dot(w, along), glm::dot(w, normal));
    };
    sum += brdf.evaluate(local(sun), local(Direction(0, 0, 1))) * glm::dot(normal, sun) * pi;
  }
  return sum / double(cells * cells);
}

/// dB of a renderer's picture, rows of red, green, blue from the bottom, against the prediction; -infinity where there
/// is none.
inline double sunPictureSnr(const QVector<float>& pixels, const Brdf& brdf, TangentAxis axis) {
  constexpr int side = sunPictureSide;
  if (pixels.size() != 3 * side * side) return -std::numeric_limits<double>::infinity();
  double energy = 0, error = 0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      if (const auto expected = sunPixel(brdf, column, row, axis))
        for (int c = 0; c < 3; ++c) {
          const double found = pixels[3 * (row * side + column) + c], wanted = (*expected)[c];
          energy += wanted * wanted;
          error += (found - wanted) * (found - wanted);
        }
  return 10 * std::log10(energy / error);
}

}  // namespace gonio::test
