// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/value_scale.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/math/round_number.h"

namespace gonio::plots {

double ValueScale::fraction(double value) const {
  if (!logarithmic) return (value - min) / (max - min);
  return value > 0 ? std::max(0.0, std::log(value / min) / std::log(max / min)) : 0.0;
}

double ValueScale::value(double fraction) const {
  return logarithmic ? min * std::pow(max / min, fraction) : min + fraction * (max - min);
}

ValueScale scaleFor(std::span<const double> values, bool logarithmic, int maxDecades, double shown) {
  std::vector<double> positive;
  std::ranges::copy_if(values, std::back_inserter(positive),
                       [](double value) { return value > 0 && std::isfinite(value); });
  if (positive.empty()) return {logarithmic, logarithmic ? 0.1 : 0.0, 1};
  const double smallest = std::ranges::min(positive);
  const auto end = positive.begin() + std::ptrdiff_t(shown * double(positive.size() - 1));
  std::ranges::nth_element(positive, end);
  const double largest = *end;
  if (!logarithmic) return {false, 0, largest * 1.05};
  const double top = std::ceil(std::log10(largest) - 1e-9);
  const double bottom = std::clamp(std::floor(std::log10(smallest) + 1e-9), top - maxDecades, top - 1);
  return {true, std::pow(10, bottom), std::pow(10, top)};
}

std::vector<double> scaleTicks(const ValueScale& scale, int count) {
  std::vector<double> ticks;
  if (scale.logarithmic) {
    const int first = int(std::ceil(std::log10(scale.min) - 1e-9)),
              last = int(std::floor(std::log10(scale.max) + 1e-9));
    const int step = std::max(1, (last - first + count - 1) / std::max(1, count));
    for (int exponent = last; exponent >= first; exponent -= step) ticks.insert(ticks.begin(), std::pow(10, exponent));
    return ticks;
  }
  const double step = roundedUp((scale.max - scale.min) / count);
  for (double i = std::ceil(scale.min / step - 1e-9); i * step <= scale.max * (1 + 1e-12); ++i)
    if (i != 0) ticks.push_back(i * step);
  return ticks;
}

}  // namespace gonio::plots
