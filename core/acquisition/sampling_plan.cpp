// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/sampling_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "core/coordinates/grid_directions.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/support/error.h"
#include "core/support/text.h"

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

namespace {

constexpr std::array<std::string_view, 4> angleNames{"theta_i", "phi_i", "theta_o", "phi_o"};
constexpr std::string_view methodLabel = "method: ", basisLabel = "basis, SHA-256: ";
constexpr int decimals = 6;
constexpr std::size_t maxSamples = 1 << 16;
/// Half the last decimal, rounded up: 90 degrees may come back a little larger.
constexpr double angleRounding = 1e-6;

double polarDegrees(const io::CsvText& csv, const io::CsvText::Row& row, std::size_t column) {
  const double angle = csv.number(row, column);
  if (!(angle >= 0 && angle <= 90 + angleRounding))
    throw Error(io::lineText(row) + ": found " + numberText(angle) + " for " + csv.names[column] +
                ", expected degrees from 0 to 90");
  return std::min(angle, 90.0);
}

double azimuthDegrees(const io::CsvText& csv, const io::CsvText::Row& row, std::size_t column) {
  const double angle = csv.number(row, column);
  if (!(std::abs(angle) <= 360))
    throw Error(io::lineText(row) + ": found " + numberText(angle) + " for " + csv.names[column] +
                ", expected degrees from -360 to 360");
  return angle;
}

/// Whether the half-difference angles that stand in the file are those of its directions, which were read as degrees.
bool halfAnglesAgree(const io::CsvText& csv, const SamplingPlan& plan) {
  constexpr double allowed = 1e-4;  // degrees; angles near the normal are written with six decimals
  const auto thetaH = csv.column("theta_h"), thetaD = csv.column("theta_d");
  if (!thetaH || !thetaD) return false;
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const auto& [wi, wo] = plan.samples[i].directions;
    const HalfDifference at = toHalfDifference(wi, wo);
    if (std::abs(csv.number(csv.rows[i], *thetaH) - degrees(at.thetaH)) > allowed ||
        std::abs(csv.number(csv.rows[i], *thetaD) - degrees(at.thetaD)) > allowed)
      return false;
  }
  return true;
}

/// A plan of several samples within 1.6 degrees of the normal, with azimuths below 6.3 and not a whole number among
/// them, is one in radians, unless its half-difference angles say otherwise. @param plan as the rows stand in the file.
void refuseRadians(const io::CsvText& csv, const SamplingPlan& plan, const std::vector<std::array<double, 4>>& angles) {
  if (angles.size() < 3) return;
  for (const auto& [thetaI, phiI, thetaO, phiO] : angles) {
    const bool isWhole = thetaI != 0 && thetaO != 0 && thetaI == std::round(thetaI) && thetaO == std::round(thetaO);
    if (isWhole || std::max(thetaI, thetaO) > halfPi || std::max(std::abs(phiI), std::abs(phiO)) > 2 * pi) return;
  }
  if (halfAnglesAgree(csv, plan)) return;
  throw Error("all angles look like radians (theta at most 1.57), expected degrees");
}

/// The order of measurement of each row: 1 to the number of rows, each once.
void checkOrder(const io::CsvText& csv, const SamplingPlan& plan) {
  std::vector<std::size_t> lines(plan.samples.size(), 0);
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const int order = plan.samples[i].order;
    const std::string found = io::lineText(csv.rows[i]) + ": found the order " + std::to_string(order);
    if (order < 1 || std::size_t(order) > lines.size())
      throw Error(found + ", expected 1 to " + std::to_string(lines.size()) +
                  ", the number of samples; remove the column to have the order computed");
    std::size_t& line = lines[std::size_t(order) - 1];
    if (line != 0)
      throw Error(found + " a second time (first in line " + std::to_string(line) + "), expected each order once");
    line = csv.rows[i].line;
  }
}

void planOrder(SamplingPlan& plan) {
  std::vector<DirectionPair> pairs;
  for (const PlannedSample& sample : plan.samples) pairs.push_back(sample.directions);
  const std::vector<std::size_t> way = shortPath(pairs);
  for (std::size_t position = 0; position < way.size(); ++position)
    plan.samples[way[position]].order = int(position) + 1;
}

}  // namespace

std::string planCsv(const SamplingPlan& plan, const std::vector<std::string>& comments) {
  io::CsvWriter csv;
  if (!plan.method.empty()) csv.comment(std::string(methodLabel) + plan.method);
  if (!plan.basisDigest.empty()) csv.comment(std::string(basisLabel) + plan.basisDigest);
  for (const std::string& comment : comments) csv.comment(comment);
  csv.comment("theta_i, phi_i: direction of the light; theta_o, phi_o: direction of the viewer");
  csv.texts({"index", "theta_i", "phi_i", "theta_o", "phi_o", "theta_h", "theta_d", "phi_d", "order"}).endLine();
  for (const PlannedSample& sample : plan.samples) {
    const auto& [wi, wo] = sample.directions;
    const HalfDifference at = toHalfDifference(wi, wo);
    csv.integer(sample.index);
    for (const double angle : {polarAngle(wi), azimuth(wi), polarAngle(wo), azimuth(wo), at.thetaH, at.thetaD, at.phiD})
      csv.literal(io::decimalText(degrees(angle), decimals));
    csv.integer(sample.order).endLine();
  }
  return csv.str();
}

void writePlan(const SamplingPlan& plan, const std::filesystem::path& path, const std::vector<std::string>& comments) {
  io::writeFileAtomically(path, planCsv(plan, comments));
}

SamplingPlan parsePlan(std::string_view text) {
  const io::CsvText csv = io::readCsvText(text);
  const std::size_t indexColumn = csv.requiredColumn("index");
  std::array<std::size_t, 4> columns;
  for (std::size_t c = 0; c < columns.size(); ++c) columns[c] = csv.requiredColumn(angleNames[c]);
  const auto orderColumn = csv.column("order");
  if (csv.rows.size() > maxSamples)
    throw Error("found " + std::to_string(csv.rows.size()) + " samples, expected at most " +
                std::to_string(maxSamples));
  SamplingPlan plan;
  for (const std::string& comment : csv.comments) {
    if (comment.starts_with(methodLabel)) plan.method = comment.substr(methodLabel.size());
    if (comment.starts_with(basisLabel)) plan.basisDigest = comment.substr(basisLabel.size());
  }
  std::map<int, std::size_t> lines;
  std::vector<std::array<double, 4>> angles;
  for (const io::CsvText::Row& row : csv.rows) {
    PlannedSample sample;
    sample.index = csv.integer(row, indexColumn);
    if (sample.index < 1)
      throw Error(io::lineText(row) + ": found the index " + std::to_string(sample.index) + ", expected 1 or more");
    if (const auto [first, isNew] = lines.emplace(sample.index, row.line); !isNew)
      throw Error(io::lineText(row) + ": found the index " + std::to_string(sample.index) +
                  " a second time (first in line " + std::to_string(first->second) + "), expected each index once");
    const auto& a =
        angles.emplace_back(std::array{polarDegrees(csv, row, columns[0]), azimuthDegrees(csv, row, columns[1]),
                                       polarDegrees(csv, row, columns[2]), azimuthDegrees(csv, row, columns[3])});
    sample.directions = {fromSpherical(radians(a[0]), radians(a[1])), fromSpherical(radians(a[2]), radians(a[3]))};
    if (orderColumn) sample.order = csv.integer(row, *orderColumn);
    plan.samples.push_back(sample);
  }
  if (plan.samples.empty()) throw Error("found no samples");
  refuseRadians(csv, plan, angles);
  if (orderColumn) checkOrder(csv, plan);
  std::stable_sort(plan.samples.begin(), plan.samples.end(),
                   [](const PlannedSample& a, const PlannedSample& b) { return a.index < b.index; });
  if (!orderColumn) planOrder(plan);
  return plan;
}

SamplingPlan readPlan(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return parsePlan(io::readText(path)); });
}

}  // namespace gonio::acquisition
