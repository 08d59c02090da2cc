// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/sampling_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/coordinates/grid_directions.h"
#include "core/support/error.h"

namespace gonio::acquisition {

namespace {

double angleBetween(const Direction& a, const Direction& b) {
  return 2 * std::atan2(glm::length(a - b), glm::length(a + b));
}

/// The rounds of 2-opt grow with the number of pairs too: 512 take some tenths of a second.
constexpr std::size_t mostImproved = 512;

/// Both arms upright: where the way begins.
constexpr DirectionPair upright;

std::vector<std::size_t> nearestNeighbours(std::span<const DirectionPair> pairs) {
  std::vector<std::size_t> left(pairs.size()), way;
  std::iota(left.begin(), left.end(), std::size_t(0));
  DirectionPair at = upright;
  while (!left.empty()) {
    const auto next = std::min_element(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
      return armTravel(at, pairs[a]) < armTravel(at, pairs[b]);
    });
    at = pairs[*next];
    way.push_back(*next);
    left.erase(next);
  }
  return way;
}

/// The light goes down once.
std::vector<std::size_t> byPolarAngles(std::span<const DirectionPair> pairs) {
  std::vector<std::size_t> way(pairs.size());
  std::iota(way.begin(), way.end(), std::size_t(0));
  const auto key = [&](std::size_t i) { return std::tuple(-pairs[i].wi.z, -pairs[i].wo.z, azimuth(pairs[i].wo)); };
  std::ranges::stable_sort(way, {}, key);
  return way;
}

/// Turns parts of the way round while that makes it shorter. The way is open at its end.
void improve(std::vector<std::size_t>& way, std::span<const DirectionPair> pairs) {
  // Gains below this are rounding: equal ways would be exchanged for ever.
  constexpr double leastGain = 1e-9;
  const auto pairAt = [&](std::size_t position) { return position == 0 ? upright : pairs[way[position - 1]]; };
  for (bool gained = true; gained;) {
    gained = false;
    for (std::size_t first = 1; first < way.size(); ++first)
      for (std::size_t last = first + 1; last <= way.size(); ++last) {
        double before = armTravel(pairAt(first - 1), pairAt(first)), after = armTravel(pairAt(first - 1), pairAt(last));
        if (last < way.size()) {
          before += armTravel(pairAt(last), pairAt(last + 1));
          after += armTravel(pairAt(first), pairAt(last + 1));
        }
        if (after > before - leastGain) continue;
        std::reverse(way.begin() + std::ptrdiff_t(first) - 1, way.begin() + std::ptrdiff_t(last));
        gained = true;
      }
  }
}

}  // namespace

std::vector<std::size_t> SamplingPlan::measurementOrder() const {
  std::vector<std::size_t> positions(samples.size());
  std::iota(positions.begin(), positions.end(), std::size_t(0));
  std::stable_sort(positions.begin(), positions.end(),
                   [&](std::size_t a, std::size_t b) { return samples[a].order < samples[b].order; });
  return positions;
}

SamplingPlan planFor(const HalfDifferenceGrid& grid, std::span<const std::uint32_t> cells) {
  const GridDirections directions(grid);
  SamplingPlan plan;
  std::vector<DirectionPair> pairs;
  for (const std::uint32_t cell : cells) {
    if (cell >= grid.size() || !directions.at(cell).aboveHorizon)
      throw Error("cell " + std::to_string(cell) +
                  " has a direction below the horizon, expected a cell with both directions above it");
    pairs.push_back(directions.at(cell).pair);
    plan.samples.push_back({int(pairs.size()), pairs.back(), 0});
  }
  const std::vector<std::size_t> way = shortPath(pairs);
  for (std::size_t position = 0; position < way.size(); ++position)
    plan.samples[way[position]].order = int(position) + 1;
  return plan;
}

std::uint32_t nearestNode(const HalfDifferenceGrid& grid, const DirectionPair& directions) {
  if (isBelowHorizon(directions.wi) || isBelowHorizon(directions.wo))
    throw Error("found a direction below the horizon, expected polar angles up to 90 degrees");
  const HalfDifference at = toHalfDifference(directions.wi, directions.wo);
  if (!at.valid) throw Error("light and viewer are opposite each other on the horizon, so they have no half vector");
  const HalfDifferenceGrid::Position position = grid.position(at);
  const auto rounded = [](double x, int count) { return std::clamp(int(std::lround(x)), 0, count - 1); };
  // The way round about the half vector is closed: behind the last node comes the first.
  const int phiD = int(std::lround(position.phiD)) % grid.phiDCount;
  return pairNode(
      grid, grid.index(rounded(position.thetaH, grid.thetaHCount), rounded(position.thetaD, grid.thetaDCount), phiD));
}

std::uint32_t pairNode(const HalfDifferenceGrid& grid, std::size_t node) {
  const auto phiCount = std::size_t(grid.phiDCount), thetaDCount = std::size_t(grid.thetaDCount);
  const std::size_t row = node / phiCount;
  const bool isOnePair = row % thetaDCount == 0 || row / thetaDCount == 0;
  return std::uint32_t(isOnePair ? row * phiCount : node);
}

double armTravel(const DirectionPair& from, const DirectionPair& to) {
  return angleBetween(from.wi, to.wi) + angleBetween(from.wo, to.wo);
}

std::vector<std::size_t> shortPath(std::span<const DirectionPair> pairs) {
  if (pairs.size() > mostImproved) return byPolarAngles(pairs);
  std::vector<std::size_t> way = nearestNeighbours(pairs);
  improve(way, pairs);
  return way;
}

}  // namespace gonio::acquisition
