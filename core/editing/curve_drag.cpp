// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/curve_drag.h"

#include <algorithm>
#include <cmath>

#include "core/math/monotone_cubic.h"

namespace gonio::editing {

namespace {

/// A monotone cubic that owns its points.
class Cubic {
 public:
  Cubic(std::vector<double> nodes, std::vector<double> values)
      : nodes_(std::move(nodes)), values_(std::move(values)), slopes_(monotoneSlopes(nodes_, values_)) {}
  double operator()(double x) const { return evaluateMonotoneCubic(nodes_, values_, slopes_, x); }

 private:
  std::vector<double> nodes_, values_, slopes_;
};

/// From where the curve is read for a place on the axis: the ends stay.
Cubic inverseStretch(const CurveDrag& drag, double first, double last) {
  std::vector<double> to{first}, from{first};
  for (std::size_t i = 0; i < drag.to.size(); ++i) {
    if (!(drag.to[i] > to.back()) || !(drag.to[i] < last)) continue;
    to.push_back(drag.to[i]);
    from.push_back(drag.from[i]);
  }
  to.push_back(last);
  from.push_back(last);
  return {to, from};
}

}  // namespace

std::vector<double> draggedCurve(std::span<const double> nodes, std::span<const double> curve, const CurveDrag& drag) {
  std::vector<double> result(curve.begin(), curve.end());
  if (nodes.size() < 2 || drag.to.empty()) return result;
  const bool adds = drag.mode == CurveDrag::Mode::add;
  // Factors about 1, so that where nothing changes every bit stays.
  std::vector<double> amounts = drag.amounts;
  for (double& one : amounts) one -= adds ? 0 : 1;
  const Cubic amount(drag.to, amounts);
  if (drag.from != drag.to) {
    const Cubic before({nodes.begin(), nodes.end()}, result), place = inverseStretch(drag, nodes.front(), nodes.back());
    for (std::size_t i = 0; i < nodes.size(); ++i) result[i] = before(place(nodes[i]));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double change = amount(nodes[i]);
    result[i] = std::max(0.0, adds ? result[i] + change : result[i] * (1 + change));
  }
  return result;
}

std::vector<double> controlPoints(std::span<const double> nodes, std::span<const double> curve, double fraction,
                                  int maxNodes) {
  if (nodes.size() < 2) return {nodes.begin(), nodes.end()};
  double largest = 0;
  for (const double value : curve) largest = std::max(largest, std::abs(value));
  std::vector<std::size_t> chosen{0, nodes.size() - 1};
  while (int(chosen.size()) < maxNodes) {
    std::vector<double> places, values;
    for (const std::size_t i : chosen) {
      places.push_back(nodes[i]);
      values.push_back(curve[i]);
    }
    const Cubic through(places, values);
    std::size_t worst = 0;
    double error = fraction * largest;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (const double e = std::abs(through(nodes[i]) - curve[i]); e > error) {
        error = e;
        worst = i;
      }
    if (worst == 0) break;
    chosen.insert(std::upper_bound(chosen.begin(), chosen.end(), worst), worst);
  }
  std::vector<double> points;
  for (const std::size_t i : chosen) points.push_back(nodes[i]);
  return points;
}

}  // namespace gonio::editing
