// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/plan_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/support/file_in_errors.h"
#include "core/support/number_text.h"

namespace gonio::acquisition {

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
  std::string text;
  if (!plan.method.empty()) text += io::csvComment(std::string(methodLabel) + plan.method);
  if (!plan.basisDigest.empty()) text += io::csvComment(std::string(basisLabel) + plan.basisDigest);
  for (const std::string& comment : comments) text += io::csvComment(comment);
  text += "index,theta_i,phi_i,theta_o,phi_o,theta_h,theta_d,phi_d,order\n";
  for (const PlannedSample& sample : plan.samples) {
    const auto& [wi, wo] = sample.directions;
    const HalfDifference at = toHalfDifference(wi, wo);
    text += std::to_string(sample.index);
    for (const double angle : {polarAngle(wi), azimuth(wi), polarAngle(wo), azimuth(wo), at.thetaH, at.thetaD, at.phiD})
      text += "," + io::decimalText(degrees(angle), decimals);
    text += "," + std::to_string(sample.order) + "\n";
  }
  return text;
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
