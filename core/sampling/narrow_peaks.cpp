// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/narrow_peaks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace gonio {

namespace {

/// Samples whose weights are at most this multiple of the mean estimate it well: of 16,384 samples, five find a peak
/// that reflects 1 % of the light.
constexpr double resolvedRatio = 32;
constexpr double negligiblePart = 1e-4, negligibleTotal = 5e-3;
/// Cells of theta_h and theta_d in a quarter turn of the MERL grid.
constexpr double cellsOfQuarter = 90;

Direction halfVector(double thetaH, double psi, const Direction& wo) {
  return fromSpherical(thetaH, psi + std::atan2(wo.y, wo.x));
}

DirectionPair pairOf(const Direction& half, const Direction& wo) { return {2 * glm::dot(wo, half) * half - wo, wo}; }

double middle(const Range& range) { return (range.low + range.high) / 2; }

/// In cells of theta_h, whose size increases with the angle.
double position(double thetaH) { return std::sqrt(thetaH / halfPi) * cellsOfQuarter; }

class PeakFinder {
 public:
  PeakFinder(const ValueBound& values, bool isotropic, const PeakSearch& search,
             const std::function<double(const DirectionPair&)>& density)
      : values_(values), isotropic_(isotropic), search_(search), density_(density) {}

  std::vector<NarrowPeak> find() {
    constexpr int firstRings = 12, firstSectors = 4;
    for (int ring = 0; ring < firstRings; ++ring)
      for (int sector = 0; sector < firstSectors; ++sector) {
        const double start = isotropic_ ? 0 : -pi, width = (pi - start) / firstSectors;
        const auto edge = [](int index) { return halfPi * std::pow(double(index) / firstRings, 2); };
        push({edge(ring), edge(ring + 1)}, {start + sector * width, start + (sector + 1) * width});
      }
    const double negligible = negligiblePart * search_.albedo;
    for (int step = 0; !queue_.empty() && queue_.top().most > negligible; ++step) {
      const NarrowPeak widest = queue_.top();
      queue_.pop();
      const double rings = cellsOfRings(widest.box), sectors = cellsOfSectors(widest.box);
      const bool isFine = std::max(rings, sectors) <= search_.cells, isOver = step >= search_.steps;
      // The density at a few points describes a set only if the set is small.
      const bool isSmall = std::max(rings, sectors) <= smallCells;
      if (isSmall && widest.most <= resolvedRatio * search_.albedo * expectedIn(widest.box)) continue;
      if (isFine || isOver)
        keep(widest);
      else
        split(widest.box, rings > sectors);
    }
    if (total_ <= negligibleTotal * search_.albedo) return {};
    return std::move(peaks_);
  }

 private:
  struct LessLight {
    bool operator()(const NarrowPeak& a, const NarrowPeak& b) const { return a.most < b.most; }
  };
  static constexpr double smallCells = 8;

  static double cellsOfRings(const PairBox& box) { return position(box.thetaH.high) - position(box.thetaH.low); }
  /// The azimuth changes theta_d by at most its arc on the sphere.
  double cellsOfSectors(const PairBox& box) const {
    return box.psi.width() * std::min(std::sin(box.thetaH.high), box.sinO.high) / halfPi * cellsOfQuarter;
  }

  void push(const Range& thetaH, const Range& psi) {
    PairBox box(search_.thetaO, thetaH, psi, search_.phiO);
    if (box.isEmpty() || !(box.measure > 0)) return;
    const double highest = maxChannel(values_.over(box).high);
    if (!(highest > 0)) return;
    queue_.push({box, highest * box.measure * (isotropic_ ? 2 : 1)});
  }

  void split(const PairBox& box, bool inRings) {
    if (inRings) {
      const double root = (std::sqrt(box.thetaH.low) + std::sqrt(box.thetaH.high)) / 2;
      push({box.thetaH.low, root * root}, box.psi);
      push({root * root, box.thetaH.high}, box.psi);
    } else {
      push(box.thetaH, {box.psi.low, middle(box.psi)});
      push(box.thetaH, {middle(box.psi), box.psi.high});
    }
  }

  void keep(const NarrowPeak& peak) {
    if (!(peak.most < std::numeric_limits<double>::infinity())) return;  // nothing is known about it
    total_ += peak.most;
    peaks_.push_back(peak);
  }

  /// Fraction of the samples that is at least in a set.
  double expectedIn(const PairBox& box) const {
    const Direction wo = fromSpherical(middle(search_.thetaO), middle(search_.phiO));
    double least = std::numeric_limits<double>::infinity();
    const auto include = [&](double thetaH, double psi) {
      const DirectionPair pair = pairOf(halfVector(thetaH, psi, wo), wo);
      if (pair.wi.z > 0) least = std::min(least, density_(pair));
    };
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && !isotropic_) break;
      include(middle(box.thetaH), side * middle(box.psi));
      for (const double thetaH : {box.thetaH.low, box.thetaH.high})
        for (const double psi : {box.psi.low, box.psi.high}) include(thetaH, side * psi);
    }
    if (!(least < std::numeric_limits<double>::infinity()) || !(box.cosI.high > 0)) return 0;
    return least * box.measure / box.cosI.high * (isotropic_ ? 2 : 1);
  }

  const ValueBound& values_;
  bool isotropic_;
  const PeakSearch& search_;
  const std::function<double(const DirectionPair&)>& density_;
  std::priority_queue<NarrowPeak, std::vector<NarrowPeak>, LessLight> queue_;
  std::vector<NarrowPeak> peaks_;
  double total_ = 0;
};

}  // namespace

std::vector<NarrowPeak> narrowPeaks(const ValueBound& values, bool isotropic, const PeakSearch& search,
                                    const std::function<double(const DirectionPair&)>& density) {
  if (!values.isLocal()) return {};
  return PeakFinder(values, isotropic, search, density).find();
}

double albedoWithoutPeaks(const std::vector<double>& weights) {
  if (weights.empty()) return 0;
  double limit = std::numeric_limits<double>::infinity();
  for (;;) {
    double sum = 0;
    for (const double weight : weights) sum += std::clamp(weight, 0.0, limit);
    const double mean = sum / double(weights.size());
    // Each pass lowers the limit, until no weight of note exceeds it.
    if (!(mean > 0) || limit <= 1.01 * resolvedRatio * mean) return mean;
    limit = resolvedRatio * mean;
  }
}

PeakPair pairInPeak(const NarrowPeak& peak, bool isotropic, const glm::dvec2& u, const glm::dvec2& viewer) {
  const PairBox& box = peak.box;
  // The square of the sine of half the angle is uniform in solid angle and precise for narrow angles.
  const auto halved = [](double theta) { return std::pow(std::sin(theta / 2), 2); };
  const double low = halved(box.thetaH.low), high = halved(box.thetaH.high);
  const double thetaH = 2 * std::asin(std::sqrt(low + u.y * (high - low)));
  const double twice = isotropic ? 2 * u.x : u.x;
  const double side = twice < 1 ? 1 : -1, along = twice < 1 ? twice : twice - 1;
  const Direction wo =
      fromSpherical(box.thetaO.low + viewer.x * box.thetaO.width(), box.phiO.low + viewer.y * box.phiO.width());
  const Direction half = halfVector(thetaH, side * (box.psi.low + along * box.psi.width()), wo);
  const double cosD = glm::dot(half, wo);
  const DirectionPair pair = pairOf(half, wo);
  if (!(cosD > 0) || !(pair.wi.z > 0)) return {pair, 0};
  return {pair, pair.wi.z * 4 * cosD * 2 * (high - low) * box.psi.width() * (isotropic ? 2 : 1)};
}

}  // namespace gonio
