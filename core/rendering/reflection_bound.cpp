// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/reflection_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "core/brdf/value_bound.h"

namespace gonio::rendering {

namespace {

using Excess = ReflectionBound::Excess;
constexpr double noBound = std::numeric_limits<double>::infinity();

/// The largest value of a set of pairs, raised by more than the rounding errors of evaluation and bound.
double highestIn(const ValueBound& values, const PairBox& box) {
  constexpr double rounding = 1e-6;
  const double highest = maxChannel(values.over(box).high);
  return highest <= 0 ? 0 : highest < noBound ? highest * (1 + rounding) : noBound;
}

/// The pairs of a set whose cosine of theta_i is in a range, with what follows from wi + wo = 2 cos theta_d h.
PairBox shellOf(const PairBox& box, const Range& cosI) {
  const auto narrow = [](Range& range, const Range& other) {
    const double low = std::max(range.low, other.low), high = std::min(range.high, other.high);
    if (low <= high) range = {low, high};
  };
  constexpr double rounding = 1e-12;
  PairBox shell = box;
  shell.cosI = cosI;
  const Range height = cosI + box.cosO;
  if (box.cosH.low > 0)
    narrow(shell.cosD, {height.low / (2 * box.cosH.high) - rounding, height.high / (2 * box.cosH.low) + rounding});
  narrow(shell.rise, {cosI.low - box.cosO.high - rounding, cosI.high - box.cosO.low + rounding});
  return shell;
}

/// Cosines of the light within a shell differ by at most this factor.
constexpr double shellRatio = 1.6;

/// Adds the largest contribution that a set with a wide range of cosines can have: where values rise toward the
/// horizon, the cosine falls, so the set is looked at in shells of the cosine.
void includeShells(const ValueBound& values, const PairBox& box, Excess& excess) {
  constexpr int most = 60;
  Excess largest;
  double high = box.cosI.high, mostReflected = 0;
  for (int shell = 0; shell < most; ++shell) {
    const double highest = highestIn(values, shellOf(box, {box.cosI.low, high})), low = high / shellRatio;
    const bool last = shell + 1 == most || highest * high <= mostReflected || low <= box.cosI.low;
    const double value = last ? highest : highestIn(values, shellOf(box, {low, high}));
    const bool isFlat = highest <= value * 1.02;
    Excess part;
    part.include(isFlat ? highest : value, box.measure * (high / box.cosI.high));
    largest.raiseTo(part);
    if (last || isFlat) break;
    mostReflected = std::max(mostReflected, value * high);
    high = low;
  }
  for (std::size_t k = 0; k < ReflectionBound::levels; ++k) excess.above[k] += largest.above[k];
  excess.peak = std::max(excess.peak, largest.peak);
}

void include(const ValueBound& values, const PairBox& box, double sides, Excess& excess) {
  if (box.isEmpty() || !(box.measure > 0)) return;
  PairBox both = box;
  both.measure *= sides;
  if (both.cosI.low < both.cosI.high / shellRatio)
    includeShells(values, both, excess);
  else
    excess.include(highestIn(values, both), both.measure);
}

/// A range of viewers with the bound for all of them.
struct ViewerCell {
  Range theta, phi{0};
  Excess excess;
  double albedo = 0;
  bool isFine = false;  ///< a finer one would hardly be lower

  bool operator<(const ViewerCell& other) const { return albedo < other.albedo; }
};

/// Sums over cells of half vectors, with the same polar angles for all viewers.
class BoundSum {
 public:
  BoundSum(const ValueBound& values, bool isotropic) : values_(values), isotropic_(isotropic) { chooseHalfAngles(); }

  void evaluate(ViewerCell& cell) const {
    cell.excess = {};
    for (std::size_t i = 0; i + 1 < halfAngles_.size(); ++i) {
      const Range half(halfAngles_[i], halfAngles_[i + 1]);
      // Azimuths matter as far as they turn the light, also relative to its distance from the horizon.
      const double turn = 2 * std::sin(half.high) * std::sin(cell.theta.high), aloft = std::cos(cell.theta.low);
      const int sectors = 1 + int(std::ceil(mostSectors * std::max(std::min(1.0, turn), turn / (turn + aloft))));
      for (int k = 0; k < sectors; ++k) {
        const double low = sector(k, sectors), high = sector(k + 1, sectors);
        include(values_, PairBox(cell.theta, half, {low, high}, cell.phi), isotropic_ ? 2 : 1, cell.excess);
        if (!isotropic_) include(values_, PairBox(cell.theta, half, {-high, -low}, cell.phi), 1, cell.excess);
      }
      if (!(cell.excess.peak < noBound)) break;
    }
    cell.albedo = cell.excess.at(1);
  }

 private:
  static double sector(int index, int count) { return pi * std::pow(double(index) / count, 1.5); }

  /// Splits the polar angles of half vectors where the bounds of the values are widest apart.
  void chooseHalfAngles() {
    struct HalfInterval {
      Range half;
      double slack;
      bool operator<(const HalfInterval& other) const { return slack < other.slack; }
    };
    const std::size_t most = isotropic_ ? 72 : 40;
    const auto intervalOf = [this](double low, double high) {
      double slack = 0;
      for (const double viewer : {0.0, 40.0, 70.0, 82.0}) {
        const PairBox box({radians(viewer), radians(viewer + 0.5)}, {low, high}, {0, pi},
                          isotropic_ ? 0 : Range(0, 2 * pi));
        if (box.isEmpty()) continue;
        const RgbRange range = values_.over(box);
        const double apart = maxChannel(range.high - range.low) * box.measure;
        slack = std::max(slack, apart < noBound ? apart : 0);
      }
      return HalfInterval{{low, high}, slack + 1e-6 * (high - low)};
    };
    std::priority_queue<HalfInterval> queue;
    constexpr int first = 12;
    for (int i = 0; i < first; ++i)
      queue.push(intervalOf(halfPi * std::pow(double(i) / first, 2), halfPi * std::pow(double(i + 1) / first, 2)));
    while (queue.size() < most) {
      const Range widest = queue.top().half;
      queue.pop();
      const double middle = std::pow((std::sqrt(widest.low) + std::sqrt(widest.high)) / 2, 2);
      queue.push(intervalOf(widest.low, middle));
      queue.push(intervalOf(middle, widest.high));
    }
    halfAngles_.push_back(halfPi);
    for (; !queue.empty(); queue.pop()) halfAngles_.push_back(queue.top().half.low);
    std::ranges::sort(halfAngles_);
  }

  static constexpr double mostSectors = 14;

  const ValueBound& values_;
  bool isotropic_;
  std::vector<double> halfAngles_;
};

/// The largest of all viewers: ranges of viewers are split where the bound is largest, while that lowers it.
Excess largestExcess(const ValueBound& values, bool isotropic) {
  const BoundSum sum(values, isotropic);
  const int polars = isotropic ? 16 : 10, azimuths = isotropic ? 1 : 8;
  const std::size_t most = isotropic ? 64 : 120;
  std::priority_queue<ViewerCell> cells;
  for (int i = 0; i < polars; ++i)
    for (int k = 0; k < azimuths; ++k) {
      ViewerCell cell;
      cell.theta = {halfPi * i / polars, halfPi * (i + 1) / polars};
      if (!isotropic) cell.phi = {2 * pi * k / azimuths, 2 * pi * (k + 1) / azimuths};
      sum.evaluate(cell);
      if (!(cell.albedo < noBound)) return cell.excess;
      cells.push(cell);
    }
  for (std::size_t step = 0; step < most && !cells.top().isFine; ++step) {
    const ViewerCell worst = cells.top();
    cells.pop();
    const bool splitsTheta = isotropic || worst.theta.width() > worst.phi.width() / 2;
    double highest = 0;
    std::array<ViewerCell, 2> halves{worst, worst};
    for (std::size_t half = 0; half < 2; ++half) {
      Range& range = splitsTheta ? halves[half].theta : halves[half].phi;
      const double middle = (range.low + range.high) / 2;
      range = half == 0 ? Range(range.low, middle) : Range(middle, range.high);
      sum.evaluate(halves[half]);
      highest = std::max(highest, halves[half].albedo);
    }
    for (ViewerCell& half : halves) {
      half.isFine = highest > 0.98 * worst.albedo;
      cells.push(half);
    }
  }
  Excess largest;
  for (; !cells.empty(); cells.pop()) largest.raiseTo(cells.top().excess);
  return largest;
}

}  // namespace

double ReflectionBound::level(std::size_t index) {
  static const std::array<double, levels> all = [] {
    std::array<double, levels> result{};
    for (std::size_t k = 1; k < levels; ++k) result[k] = std::pow(10, -6 + 14 * double(k - 1) / (levels - 2));
    return result;
  }();
  return all[index];
}

void ReflectionBound::Excess::include(double value, double measure) {
  peak = std::max(peak, value);
  for (std::size_t k = 0; k < levels && level(k) < value; ++k) above[k] += (value - level(k)) * measure;
}

void ReflectionBound::Excess::raiseTo(const Excess& other) {
  peak = std::max(peak, other.peak);
  for (std::size_t k = 0; k < levels; ++k) above[k] = std::max(above[k], other.above[k]);
}

double ReflectionBound::Excess::at(double fraction) const {
  const double covered = pi * std::clamp(fraction, 0.0, 1.0);
  if (covered == 0 || peak == 0) return 0;
  double least = covered * peak;
  for (std::size_t k = 0; k < levels; ++k) least = std::min(least, covered * level(k) + above[k]);
  return least;
}

ReflectionBound::ReflectionBound(const Brdf& brdf) {
  if (const auto values = brdf.valueBound()) {
    excess_ = largestExcess(*values, brdf.isIsotropic());
  } else {
    excess_.above.fill(noBound);
    excess_.peak = noBound;
  }
}

ReflectionBound ReflectionBound::ofDiffuse(double albedo) {
  ReflectionBound bound;
  bound.excess_.include(albedo / pi, pi);
  return bound;
}

double ReflectionBound::at(double fraction) const { return excess_.at(fraction); }

bool ReflectionBound::isFinite() const { return excess_.peak < noBound; }

}  // namespace gonio::rendering
