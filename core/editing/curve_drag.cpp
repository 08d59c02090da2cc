// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/curve_drag.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/math/monotone_cubic.h"

namespace gonio::editing {

namespace {

/// A cubic that owns its points, monotone unless other slopes are given.
class Cubic {
 public:
  Cubic(std::vector<double> nodes, std::vector<double> values)
      : nodes_(std::move(nodes)), values_(std::move(values)), slopes_(monotoneSlopes(nodes_, values_)) {}
  Cubic(std::vector<double> nodes, std::vector<double> values, std::vector<double> slopes)
      : nodes_(std::move(nodes)), values_(std::move(values)), slopes_(std::move(slopes)) {}
  double operator()(double x) const { return evaluateMonotoneCubic(nodes_, values_, slopes_, x); }
  const std::vector<double>& slopes() const { return slopes_; }

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

/// The cubics through the points at their new places, with the values before and after the drag.
struct PointCurves {
  std::vector<double> places, valuesBefore, valuesAfter;
  Cubic before, after;

  PointCurves(const Cubic& curve, const CurveDrag& drag)
      : places(drag.to),
        valuesBefore(valuesOf(curve, drag)),
        valuesAfter(changedValues(valuesBefore, drag)),
        before(places, valuesBefore),
        after(places, valuesAfter, slopesAfter()) {}

  /// Whether an end of the interval from point k - 1 to point k moves up or down.
  bool changes(std::size_t k) const {
    return valuesBefore[k - 1] != valuesAfter[k - 1] || valuesBefore[k] != valuesAfter[k];
  }

 private:
  static std::vector<double> valuesOf(const Cubic& curve, const CurveDrag& drag) {
    std::vector<double> values;
    values.reserve(drag.from.size());
    for (const double place : drag.from) values.push_back(curve(place));
    return values;
  }
  static std::vector<double> changedValues(std::vector<double> values, const CurveDrag& drag) {
    const bool adds = drag.mode == CurveDrag::Mode::add;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = std::max(0.0, adds ? values[i] + drag.amounts[i] : values[i] * drag.amounts[i]);
    return values;
  }
  /// Where an interval keeps both its ends, it keeps its slopes too, and so its curve.
  std::vector<double> slopesAfter() const {
    std::vector<double> slopes = monotoneSlopes(places, valuesAfter);
    for (std::size_t k = 1; k < places.size(); ++k)
      if (!changes(k))
        for (const std::size_t i : {k - 1, k}) slopes[i] = before.slopes()[i];
    return slopes;
  }
};

/// Between two points the curve rises or falls as they do, if it did so before the change: the largest value so far
/// takes the place of a dip.
void keepMonotone(std::span<const double> nodes, std::span<const double> before, const PointCurves& points,
                  std::size_t k, std::span<double> result) {
  if (!points.changes(k)) return;
  const auto begin = std::size_t(std::ranges::lower_bound(nodes, points.places[k - 1]) - nodes.begin());
  const auto end = std::size_t(std::ranges::upper_bound(nodes, points.places[k]) - nodes.begin());
  const auto old = before.subspan(begin, end - begin);
  const auto now = result.subspan(begin, end - begin);
  const double first = points.valuesAfter[k - 1], last = points.valuesAfter[k];
  if (!std::ranges::is_sorted(old) && !std::ranges::is_sorted(old, std::greater<>())) return;
  double so = first;
  for (double& value : now) {
    value = first <= last ? std::clamp(value, so, last) : std::clamp(value, last, so);
    so = value;
  }
}

}  // namespace

std::vector<double> draggedCurve(std::span<const double> nodes, std::span<const double> curve, const CurveDrag& drag) {
  std::vector<double> result(curve.begin(), curve.end());
  if (nodes.size() < 2 || drag.to.empty()) return result;
  const Cubic before({nodes.begin(), nodes.end()}, result);
  const PointCurves points(before, drag);
  if (drag.from != drag.to) {
    const Cubic place = inverseStretch(drag, nodes.front(), nodes.back());
    for (std::size_t i = 0; i < nodes.size(); ++i) result[i] = before(place(nodes[i]));
  }
  const std::vector<double> stretched = result;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double was = points.before(nodes[i]), is = points.after(nodes[i]);
    if (is == was) continue;
    const bool multiplies = drag.mode == CurveDrag::Mode::multiply && was > 0;
    result[i] = std::max(0.0, multiplies ? stretched[i] * (is / was) : stretched[i] + (is - was));
  }
  for (std::size_t k = 1; k < drag.to.size(); ++k) keepMonotone(nodes, stretched, points, k, result);
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
    places.reserve(chosen.size());
    values.reserve(chosen.size());
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
  points.reserve(chosen.size());
  for (const std::size_t i : chosen) points.push_back(nodes[i]);
  return points;
}

}  // namespace gonio::editing
