// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace gonio::plots {

/// A linear or logarithmic axis, which converts values to fractions of its length and back.
struct ValueScale {
  bool logarithmic = false;
  double min = 0, max = 1;  ///< min < max; min > 0 if logarithmic

  /// The fraction of a value: in [0, 1] between min and max, otherwise outside. On a logarithmic scale, values <= 0
  /// have the fraction 0.
  double fraction(double value) const;
  double value(double fraction) const;
};

/// A scale for given values: linear from 0 to slightly above the largest; logarithmic over whole decades from the
/// smallest positive to the largest value, at most `maxDecades`. NaN and infinities are ignored; without positive
/// values it is [0, 1] or [0.1, 1].
/// @param shown in (0, 1]: the quantile of the positive values at the upper end of the scale, so that few very large
/// values do not compress the rest.
ValueScale scaleFor(std::span<const double> values, bool logarithmic, int maxDecades = 8, double shown = 1);

/// About `count` ascending tick values inside the scale, in steps of 1, 2 or 5 times a power of ten; on a logarithmic
/// scale powers of ten. 0 is omitted (the origin of a radial axis).
std::vector<double> scaleTicks(const ValueScale& scale, int count = 4);

/// Clips a polyline to the rectangle [min, max], for formats without clipping such as SVG 1.2 Tiny; the parts end
/// exactly at the edges. A point that is not finite ends a part. Liang and Barsky 1984, "A New Concept and Method for
/// Line Clipping".
std::vector<std::vector<glm::dvec2>> clipPolyline(std::span<const glm::dvec2> points, const glm::dvec2& min,
                                                  const glm::dvec2& max);

}  // namespace gonio::plots
