// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

namespace gonio::plots {

/// A linear or logarithmic axis of values: from a value to a fraction of the axis and back.
struct ValueScale {
  bool logarithmic = false;
  double min = 0, max = 1;  ///< min < max; min > 0 where logarithmic

  /// In [0, 1] between min and max; outside beyond it. On a logarithmic scale, values <= 0 lie at 0.
  double fraction(double value) const;
  double value(double fraction) const;
};

/// A scale that shows all of the values: linear from 0 to a little more than the largest; logarithmic over whole
/// decades from the smallest positive to the largest value, at most `maxDecades` of them. NaN and infinities are left
/// out; a scale without positive values is [0, 1] or [0.1, 1].
/// @param shown (0, 1]: of the positive values this fraction, the smallest ones, decides where the scale ends, so that
/// a few that are far larger do not darken the rest
ValueScale scaleFor(std::span<const double> values, bool logarithmic, int maxDecades = 8, double shown = 1);

/// Round values inside the scale for ticks, ascending: 1, 2 or 5 times a power of ten apart, about `count` of them; on
/// a logarithmic scale powers of ten, thinned to about `count`. 0 is left out (it is where a radial axis begins).
std::vector<double> scaleTicks(const ValueScale& scale, int count = 4);

}  // namespace gonio::plots
