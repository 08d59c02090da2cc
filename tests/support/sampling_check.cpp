// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/support/sampling_check.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/math/quadrature.h"
#include "core/math/special_functions.h"

namespace gonio::test {

namespace {

/// The upper hemisphere in polar coordinates about the mirror direction of a viewer, where most lobes have their peak
/// and densities of half vectors a pole: `distance` is the logarithm of the angle from the mirror direction over that
/// at which the horizon is met, [0, 1]; `phi` the azimuth about it, [0, 2 pi).
class MirrorCoordinates {
 public:
  struct Point {
    double distance, phi;
  };

  explicit MirrorCoordinates(const Direction& wo);
  Point pointOf(const Direction& w) const;
  /// The direction, and the solid angle that a unit of distance times a radian of phi covers there.
  Direction directionOf(const Point& point, double& solidAngle) const;

 private:
  double horizon(double cosPhi, double sinPhi) const;

  Direction mirror_, first_, second_;
};

struct HemisphereCell {
  MirrorCoordinates::Point low, high;
};

constexpr int pilotDraws = 1 << 13, cellFraction = 64, maxDepth = 40, startDepth = 10;
const double decades = std::log(1e10);  // of the angle from the mirror direction

MirrorCoordinates::MirrorCoordinates(const Direction& wo) : mirror_(-wo.x, -wo.y, wo.z) {
  const Direction aside = std::abs(mirror_.z) < 0.9 ? Direction(0, 0, 1) : Direction(1, 0, 0);
  first_ = glm::normalize(glm::cross(aside, mirror_));
  second_ = glm::cross(mirror_, first_);
}

/// Where z = 0: cos r mirror.z + sin r (cosPhi first.z + sinPhi second.z) = 0.
double MirrorCoordinates::horizon(double cosPhi, double sinPhi) const {
  return std::atan2(mirror_.z, -(cosPhi * first_.z + sinPhi * second_.z));
}

MirrorCoordinates::Point MirrorCoordinates::pointOf(const Direction& w) const {
  const double x = glm::dot(w, first_), y = glm::dot(w, second_), phi = std::atan2(y, x);
  const double r = 2 * std::asin(std::min(1.0, glm::length(w - mirror_) / 2));
  const double fraction = r / horizon(std::cos(phi), std::sin(phi));
  return {std::max(0.0, 1 + std::log(fraction) / decades), phi < 0 ? phi + 2 * pi : phi};
}

Direction MirrorCoordinates::directionOf(const Point& point, double& solidAngle) const {
  const double c = std::cos(point.phi), s = std::sin(point.phi),
               r = horizon(c, s) * std::exp(decades * (point.distance - 1));
  solidAngle = std::sin(r) * r * decades;
  return std::cos(r) * mirror_ + std::sin(r) * (c * first_ + s * second_);
}

std::vector<DirectionSample> drawMany(const Brdf& brdf, const Direction& wo, int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<DirectionSample> result;
  for (int n = 0; n < count; ++n) {
    const double first = uniform(random), second = uniform(random), third = uniform(random);
    result.push_back(brdf.sample(wo, {first, second, third}));
  }
  return result;
}

using Point = MirrorCoordinates::Point;

Point middle(const HemisphereCell& cell) {
  return {(cell.low.distance + cell.high.distance) / 2, (cell.low.phi + cell.high.phi) / 2};
}

/// Cells that are small where directions are drawn often: halved until none holds much more than a 64th of the points.
class Cells {
 public:
  explicit Cells(std::vector<Point> points) { split({{0, 0}, {1, 2 * pi}}, points, 0); }
  const std::vector<HemisphereCell>& all() const { return cells_; }
  std::size_t indexOf(const Point& p) const {
    std::size_t node = 0;
    while (!nodes_[node].isLeaf) node = p.*nodes_[node].along < nodes_[node].border ? node + 1 : nodes_[node].high;
    return nodes_[node].high;
  }

 private:
  /// The lower half follows its node; `high` is the node of the upper half, or the cell of a leaf.
  struct Node {
    bool isLeaf;
    std::size_t high;
    double Point::*along = nullptr;
    double border = 0;
  };

  void split(const HemisphereCell& cell, std::span<Point> points, int depth) {
    const std::size_t node = nodes_.size();
    nodes_.push_back({true, cells_.size()});
    if (points.size() <= std::size_t(pilotDraws / cellFraction) || depth == maxDepth) return cells_.push_back(cell);
    double Point::*const along = depth % 2 == 0 ? &Point::distance : &Point::phi;
    const double border = middle(cell).*along;
    HemisphereCell low = cell, high = cell;
    low.high.*along = high.low.*along = border;
    const auto second = std::partition(points.begin(), points.end(), [&](const Point& p) { return p.*along < border; });
    split(low, {points.begin(), second}, depth + 1);
    nodes_[node] = {false, nodes_.size(), along, border};
    split(high, {second, points.end()}, depth + 1);
  }

  std::vector<Node> nodes_;
  std::vector<HemisphereCell> cells_;
};

/// The same place where 2 % more would be below the horizon.
Point widenedPlace(const Point& place) {
  static const double step = std::log(1.02) / decades;
  return {place.distance + step < 1 ? place.distance + step : place.distance, place.phi};
}

struct Integrand {
  const Brdf& brdf;
  const Direction& wo;
  const MirrorCoordinates& coordinates;
};

double ruleOver(const Integrand& integrand, const HemisphereCell& cell) {
  static const QuadratureRule rule = gaussLegendre(7, 0, 1);
  const double width = cell.high.distance - cell.low.distance, height = cell.high.phi - cell.low.phi;
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const Point at{cell.low.distance + rule.nodes[i] * width, cell.low.phi + rule.nodes[j] * height};
      double solidAngle = 0;
      const Direction w = integrand.coordinates.directionOf(at, solidAngle);
      sum += rule.weights[i] * rule.weights[j] * solidAngle * integrand.brdf.pdf(w, integrand.wo);
    }
  return sum * width * height;
}

double adaptive(const Integrand& integrand, const HemisphereCell& cell, double whole, double tolerance, int depth) {
  const Point m = middle(cell);
  const HemisphereCell parts[] = {{cell.low, m},
                                  {m, cell.high},
                                  {{cell.low.distance, m.phi}, {m.distance, cell.high.phi}},
                                  {{m.distance, cell.low.phi}, {cell.high.distance, m.phi}}};
  double values[4], sum = 0;
  for (int i = 0; i < 4; ++i) sum += values[i] = ruleOver(integrand, parts[i]);
  if ((depth < startDepth && std::abs(sum - whole) < tolerance) || depth == 0) return sum;
  sum = 0;
  for (int i = 0; i < 4; ++i) sum += adaptive(integrand, parts[i], values[i], tolerance / 2, depth - 1);
  return sum;
}

std::vector<Point> pilotPoints(const Brdf& brdf, const Direction& wo) {
  const MirrorCoordinates coordinates(wo);
  std::vector<Point> points;
  for (const DirectionSample& sample : drawMany(brdf, wo, pilotDraws, 1))
    if (sample.pdf > 0) points.push_back(coordinates.pointOf(sample.wi));
  return points;
}

/// Integral of the density over a cell: adaptive Gauss-Legendre.
double integralOfPdf(const Brdf& brdf, const Direction& wo, const HemisphereCell& cell, double tolerance) {
  const MirrorCoordinates coordinates(wo);
  const Integrand integrand{brdf, wo, coordinates};
  return adaptive(integrand, cell, ruleOver(integrand, cell), tolerance, startDepth);
}

/// The probability that chi-squared of so many degrees of freedom is at least as large.
double chiSquaredTail(double chiSquared, int degrees) {
  return std::exp(logUpperIncompleteGamma(degrees / 2.0, std::max(1e-12, chiSquared / 2)) - std::lgamma(degrees / 2.0));
}

}  // namespace

double pearsonPValue(const std::vector<double>& expected, const std::vector<double>& observed) {
  constexpr double fewest = 10;
  double chiSquared = 0, pooledExpected = 0, pooledObserved = 0;
  int cells = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    pooledExpected += expected[i];
    pooledObserved += observed[i];
    if (pooledExpected < fewest) continue;
    chiSquared += (pooledObserved - pooledExpected) * (pooledObserved - pooledExpected) / pooledExpected;
    pooledExpected = pooledObserved = 0;
    ++cells;
  }
  return cells > 1 ? chiSquaredTail(chiSquared, cells - 1) : 1;
}

Direction widened(const Direction& wi, const Direction& wo) {
  const MirrorCoordinates coordinates(wo);
  double solidAngle = 0;
  return coordinates.directionOf(widenedPlace(coordinates.pointOf(wi)), solidAngle);
}

SamplingCheck checkSampling(const Brdf& brdf, const Direction& wo, int draws, double tolerance) {
  const MirrorCoordinates coordinates(wo);
  const Cells cells(pilotPoints(brdf, wo));
  SamplingCheck check;
  std::vector<double> expected, observed(cells.all().size(), 0), wider = observed;
  for (const HemisphereCell& cell : cells.all()) {
    const double fraction = integralOfPdf(brdf, wo, cell, tolerance);
    check.integral += fraction;
    expected.push_back(fraction * draws);
  }
  for (const DirectionSample& sample : drawMany(brdf, wo, draws, 2)) {
    if (sample.pdf == 0) {
      check.lost += 1.0 / draws;
      continue;
    }
    check.valid = check.valid && sample.wi.z > 0 && std::isfinite(sample.pdf) && sample.pdf > 0 &&
                  sample.pdf == brdf.pdf(sample.wi, wo) && std::abs(glm::length(sample.wi) - 1) < 1e-9;
    const Point place = coordinates.pointOf(sample.wi), further = widenedPlace(place);
    observed[cells.indexOf(place)] += 1;
    wider[cells.indexOf(further)] += 1;
  }
  check.pValue = pearsonPValue(expected, observed);
  check.widerPValue = pearsonPValue(expected, wider);
  return check;
}

}  // namespace gonio::test
