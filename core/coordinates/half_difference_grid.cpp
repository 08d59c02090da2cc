// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/half_difference_grid.h"

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

struct Indices {
  int i, j, k;
};

Indices split(const HalfDifferenceGrid& grid, std::size_t index) {
  const auto phi = std::size_t(grid.phiDCount), td = std::size_t(grid.thetaDCount);
  return {int(index / (phi * td)), int(index / phi % td), int(index % phi)};
}

double thetaHAt(const HalfDifferenceGrid& grid, double i) {
  const double x = i / grid.thetaHCount;
  return x * x * halfPi;
}

}  // namespace

HalfDifference HalfDifferenceGrid::node(std::size_t index) const {
  const auto [i, j, k] = split(*this, index);
  return {thetaHAt(*this, i), double(j) / thetaDCount * halfPi, double(k) / phiDCount * phiDPeriod(), true};
}

DirectionPair HalfDifferenceGrid::directions(std::size_t index) const {
  const HalfDifference at = node(index);
  return fromHalfDifference(at.thetaH, at.thetaD, at.phiD);
}

bool HalfDifferenceGrid::nodeAboveHorizon(std::size_t index) const {
  const HalfDifference at = node(index);
  return isAboveHorizon(at.thetaH, at.thetaD, at.phiD);
}

bool HalfDifferenceGrid::nodeWithin(std::size_t index, double maxPolarAngle) const {
  const auto [wi, wo] = directions(index);
  return polarAngle(wi) <= maxPolarAngle && polarAngle(wo) <= maxPolarAngle;
}

double HalfDifferenceGrid::cellMeasure(std::size_t index) const {
  const auto [i, j, k] = split(*this, index);
  const double thetaHLow = thetaHAt(*this, std::max(0.0, i - 0.5));
  const double thetaHHigh = thetaHAt(*this, std::min<double>(thetaHCount, i + 0.5));
  const double step = halfPi / thetaDCount;
  const double thetaDLow = std::max(0.0, j - 0.5) * step, thetaDHigh = std::min<double>(thetaDCount, j + 0.5) * step;
  // The integrals of sin x and of 4 sin x cos x are closed: exact even where the highlight cells are tiny.
  const double half = 2 * std::sin((thetaHHigh + thetaHLow) / 2) * std::sin((thetaHHigh - thetaHLow) / 2);
  const double difference = 2 * std::sin(thetaDHigh + thetaDLow) * std::sin(thetaDHigh - thetaDLow);
  return half * difference * phiDPeriod() / phiDCount;
}

std::size_t HalfDifferenceGrid::cellIndex(const HalfDifference& c) const {
  const Position p = position(c);
  const auto cell = [](double x, int count) { return std::clamp(static_cast<int>(std::floor(x)), 0, count - 1); };
  return index(cell(p.thetaH, thetaHCount), cell(p.thetaD, thetaDCount), cell(p.phiD, phiDCount));
}

}  // namespace gonio
