// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/slider_range.h"

#include <algorithm>
#include <cmath>

namespace gonio::widgets {

namespace {

/// The end of a slider that begins at `start` and has `value` at four fifths.
double endBeyond(double start, double value, models::ParameterScale scale) {
  constexpr double stretch = 1.25;
  if (scale == models::ParameterScale::logarithmic && start > 0 && value > 0)
    return start * std::pow(value / start, stretch);
  return start + stretch * (value - start);
}

}  // namespace

std::pair<double, double> sliderRange(const models::ParameterSpec& spec, double fitted) {
  double low = spec.softMin, high = spec.softMax;
  if (fitted > high) high = std::min(spec.hardMax, endBeyond(low, fitted, spec.scale));
  if (fitted < low) low = std::max(spec.hardMin, endBeyond(high, fitted, spec.scale));
  return {low, high};
}

}  // namespace gonio::widgets
