// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/scattered_samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/acquisition/reconstruction.h"
#include "core/io/csv_text.h"
#include "core/materials/basis_file.h"
#include "core/support/text.h"

namespace gonio::formats {

namespace {

using dictionary::MappedCells;

constexpr std::size_t maxNodes = 8192;

/// All points at one node.
struct NodePoints {
  Rgb sum{0}, variance{0};
  std::size_t count = 0;
};

struct GatheredPoints {
  std::map<std::uint32_t, NodePoints> nodes;
  std::size_t used = 0, outside = 0;
};

/// The node of a pair if the bundled materials have values there.
std::optional<std::uint32_t> knownNode(const MappedCells& mapping, const DirectionPair& pair) {
  if (!(glm::length(pair.wi + pair.wo) > 0)) return std::nullopt;
  const std::uint32_t node = acquisition::nearestNode(mapping.grid, pair);
  if (!std::binary_search(mapping.cells.begin(), mapping.cells.end(), node)) return std::nullopt;
  return node;
}

GatheredPoints gather(const ScatteredSamples& samples, const MappedCells& mapping) {
  GatheredPoints points;
  for (std::size_t i = 0; i < samples.values.size(); ++i) {
    const auto node = knownNode(mapping, samples.directions[i]);
    if (!node) {
      ++points.outside;
      continue;
    }
    NodePoints& at = points.nodes[*node];
    at.sum += samples.values[i];
    if (!samples.standardDeviations.empty())
      at.variance += samples.standardDeviations[i] * samples.standardDeviations[i];
    ++at.count;
  }
  return points;
}

struct Measured {
  acquisition::SamplingPlan plan;
  acquisition::MeasuredValues values;
};

/// Means of the points at each node, at most maxNodes of them. Counts the points that are used.
Measured measuredAt(GatheredPoints& points, const HalfDifferenceGrid& grid, bool hasDeviations) {
  Measured measured;
  const std::size_t total = points.nodes.size(), kept = std::min(total, maxNodes);
  std::size_t position = 0;
  for (const auto& [node, at] : points.nodes) {
    const std::size_t p = position++;
    // `kept` of `total` positions, evenly.
    if ((p + 1) * kept / total == p * kept / total) continue;
    const int index = int(measured.plan.samples.size()) + 1;
    measured.plan.samples.push_back({index, grid.directions(node), index});
    measured.values.rgb.push_back(at.sum / double(at.count));
    if (hasDeviations) measured.values.noise.push_back(glm::sqrt(at.variance) / double(at.count));
    points.used += at.count;
  }
  return measured;
}

void addCounts(const ScatteredSamples& samples, std::vector<std::string>& notes) {
  if (samples.belowHorizonCount > 0)
    notes.push_back(std::to_string(samples.belowHorizonCount) + " samples at or below the horizon were left out");
  if (samples.clampedCount > 0)
    notes.push_back(std::to_string(samples.clampedCount) + " negative values were set to 0");
}

std::string factorText(double logarithm) { return io::decimalText(std::exp(std::min(logarithm, 20.0)), 2); }

void addNotes(const ScatteredSamples& samples, const GatheredPoints& points, std::size_t nodes,
              const acquisition::Reconstruction& reconstruction, std::vector<std::string>& notes) {
  notes.insert(notes.end(), samples.notes.begin(), samples.notes.end());
  const auto count = [](std::size_t number) { return std::to_string(number); };
  notes.push_back("measured at individual directions: " + count(points.used) + " samples at " + count(nodes) +
                  " grid nodes are used; all other values are reconstructed from principal components of the bundled "
                  "materials, assuming an isotropic, reciprocal material");
  const std::size_t leftOut = samples.values.size() - points.used;
  if (leftOut > 0 && leftOut == points.outside)
    notes.push_back(count(leftOut) + " samples too close to the horizon were left out");
  else if (leftOut > 0)
    notes.push_back(count(leftOut) + " samples were left out: " + count(points.outside) +
                    " too close to the horizon, the others to limit the number of nodes");
  addCounts(samples, notes);
  if (std::isfinite(reconstruction.leaveOneOutError))
    notes.push_back("leave-one-out error: a measured value is predicted from the others within a factor of " +
                    factorText(reconstruction.leaveOneOutError) + " (root mean square)");
  else
    notes.push_back("leave-one-out error: unknown, because the samples do not predict each other");
}

/// The reconstruction without values that neither a bundled material has at a node nor the measurement anywhere: what
/// the measured points say nothing about, the components may exaggerate without bound. Counts the channels.
std::shared_ptr<const TabulatedBrdf> limited(const TabulatedBrdf& table, const std::vector<float>& largest,
                                             const acquisition::MeasuredValues& measured, std::size_t& count) {
  double maxMeasured = 0;
  for (const Rgb& value : measured.rgb) maxMeasured = std::max(maxMeasured, maxChannel(value));
  std::vector<TabulatedBrdf::Value> values(table.values().begin(), table.values().end());
  for (std::size_t cell = 0; cell < values.size(); ++cell)
    for (int channel = 0; channel < 3; ++channel) {
      const float limit = std::max(largest[cell], float(maxMeasured));
      count += values[cell][channel] > limit;
      values[cell][channel] = std::min(values[cell][channel], limit);
    }
  return std::make_shared<const TabulatedBrdf>(table.grid(), std::move(values),
                                               std::vector<std::uint8_t>(table.valid().begin(), table.valid().end()));
}

}  // namespace

namespace {

constexpr double angleRounding = 0.01;  // of angles with few digits

/// What the largest and the simplest angles of a file say about their unit.
struct AngleEvidence {
  double largest = 0, polar = 0;  ///< magnitudes; of all angles, of polar angles
  /// An angle that has four digits or more of a multiple of 15 degrees in radians; multiples of 0.001, which scans in
  /// degrees have, are none.
  double fraction = 0;

  explicit AngleEvidence(std::span<const std::array<double, 4>> angles) {
    for (const std::array<double, 4>& row : angles)
      for (std::size_t i = 0; i < row.size(); ++i) {
        const double angle = std::abs(row[i]), steps = angle / (pi / 12);
        largest = std::max(largest, angle);
        if (i % 2 == 0) polar = std::max(polar, angle);
        if (angle > angleRounding && std::abs(steps - std::round(steps)) < 4e-4 &&
            std::abs(angle * 1000 - std::round(angle * 1000)) > 1e-6)
          fraction = angle;
      }
  }
  /// Whether the angles can be radians, by their magnitudes.
  bool canBeRadians() const { return !(largest > 2 * pi + angleRounding) && !(polar > halfPi + angleRounding); }
  [[noreturn]] void failAsAmbiguous(const std::string& choice) const {
    throw Error("found no angle above " + numberText(largest) +
                ", so that the angles may be degrees or radians; expected angles in a known unit: " + choice);
  }
};

constexpr AngleUnit inDegrees{gonio::radians(1), "degrees"};

}  // namespace

AngleUnit AngleUnit::guessed(std::span<const std::array<double, 4>> angles, const std::string& choice) {
  const AngleEvidence found(angles);
  if (found.canBeRadians()) {
    if (found.largest > 0 && !(found.fraction > 0)) found.failAsAmbiguous(choice);
    return {};
  }
  if (found.largest > 2 * pi + angleRounding || found.polar > pi + angleRounding || !(found.fraction > 0))
    return inDegrees;
  throw Error("found the polar angle " + numberText(found.polar) +
              ", which in radians is below the horizon, and the angle " + numberText(found.fraction) +
              ", which looks like radians; expected angles in a known unit: " + choice);
}

AngleUnit AngleUnit::degreesUnlessRadians(std::span<const std::array<double, 4>> angles, const std::string& choice) {
  const AngleEvidence found(angles);
  if (found.fraction > 0 && !(found.largest > 2 * pi + angleRounding))
    throw Error("found no angle above " + numberText(found.largest) + ", and the angle " + numberText(found.fraction) +
                ", which looks like radians; expected degrees, or a stated unit: " + choice);
  if (found.largest > 0 && found.canBeRadians()) found.failAsAmbiguous(choice);
  return inDegrees;
}

void setScattered(const ScatteredSamples& samples, const TaskControl& control, materials::Material& material) {
  const auto basis = materials::bundledBasis(control.between(0, 0.6));
  const MappedCells& mapping = basis->components.mapping;
  GatheredPoints points = gather(samples, mapping);
  if (points.nodes.empty())
    throw Error("found " + std::to_string(samples.values.size()) +
                " samples, expected at least one away from the horizon");
  const Measured measured = measuredAt(points, mapping.grid, !samples.standardDeviations.empty());
  const acquisition::Reconstruction reconstruction = acquisition::reconstruct(
      basis->components, measured.plan, measured.values, {.uncertainty = false}, control.between(0.6, 0.9));
  std::size_t limitedCount = 0;
  const auto table = limited(*reconstruction.table, basis->largest, measured.values, limitedCount);
  material.table = bakeTable(*table, {}, control.between(0.9, 1));
  material.brdf = material.table;
  material.source.grid = {int(samples.values.size())};
  material.source.description = samples.description;
  addNotes(samples, points, measured.plan.samples.size(), reconstruction, material.source.notes);
  if (limitedCount > 0)
    material.source.notes.push_back(
        std::to_string(limitedCount) +
        " reconstructed values were limited to the maximum of the bundled materials at the same "
        "angles, or to the largest measured value if that is larger");
}

namespace {

/// Angles closer than this are one node; files round them to some digits.
constexpr double angleTolerance = 1e-5;
/// The largest steps between nodes across which values are interpolated.
constexpr double maxPolarStep = radians(30) + angleTolerance, maxAzimuthStep = radians(45) + angleTolerance;

/// Ascending angles, each once.
std::vector<double> nodesOf(std::vector<double> angles) {
  std::ranges::sort(angles);
  std::vector<double> nodes;
  for (const double angle : angles)
    if (nodes.empty() || angle - nodes.back() > angleTolerance) nodes.push_back(angle);
  return nodes;
}

std::optional<std::size_t> nodeAt(const std::vector<double>& nodes, double angle) {
  const auto found = std::ranges::lower_bound(nodes, angle - angleTolerance);
  if (found == nodes.end() || *found > angle + angleTolerance) return std::nullopt;
  return std::size_t(found - nodes.begin());
}

/// In [0, 2 pi), without the rounding below 2 pi.
double positiveAzimuth(double angle) {
  const double positive = angle < 0 ? angle + 2 * pi : angle;
  return positive > 2 * pi - angleTolerance ? 0 : positive;
}

double largestStep(const std::vector<double>& nodes) {
  double largest = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) largest = std::max(largest, nodes[i] - nodes[i - 1]);
  return largest;
}

/// A pair by its angles, rad. Where the light is at the normal, its azimuth is 0.
struct PairAngles {
  double thetaI, phiI, thetaO, difference;

  explicit PairAngles(const DirectionPair& pair)
      : thetaI(polarAngle(pair.wi)),
        phiI(isLightAtNormal() ? 0 : positiveAzimuth(azimuth(pair.wi))),
        thetaO(polarAngle(pair.wo)),
        difference(positiveAzimuth(std::remainder(azimuth(pair.wo) - phiI, 2 * pi))) {}
  bool isLightAtNormal() const { return !(thetaI > angleTolerance); }
  bool isViewerAtNormal() const { return !(thetaO > angleTolerance); }
};

/// The node of a pair; of all that are the same pair, since an azimuth at the normal says nothing, the first.
using PairNode = std::array<std::size_t, 4>;
std::optional<PairNode> nodeOf(const IncidenceTable& table, const PairAngles& at) {
  const std::optional<std::size_t> nodes[]{
      nodeAt(table.incident, at.thetaI), at.isLightAtNormal() ? 0 : nodeAt(table.rotations, at.phiI),
      nodeAt(table.polars, at.thetaO), at.isViewerAtNormal() ? 0 : nodeAt(table.azimuths, at.difference)};
  PairNode result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!nodes[i]) return std::nullopt;
    result[i] = *nodes[i];
  }
  return result;
}

/// The nodes of a measurement, without values. Empty if they are too far apart or too many for the measurement.
std::optional<IncidenceTable> nodesOf(std::vector<PairAngles>& pairs) {
  const auto isOn = [&](auto isSide) {
    return std::ranges::all_of(pairs, [&](const PairAngles& at) {
      return at.isLightAtNormal() || at.isViewerAtNormal() || isSide(at.difference);
    });
  };
  // One side of the plane of incidence is as good as the other.
  if (isOn([](double angle) { return !(angle > angleTolerance) || angle > pi - angleTolerance; }))
    for (PairAngles& at : pairs) at.difference = positiveAzimuth(2 * pi - at.difference);
  std::vector<double> lights, viewers, azimuths, differences;
  for (const PairAngles& at : pairs) {
    lights.push_back(at.thetaI);
    viewers.push_back(at.thetaO);
    if (at.isLightAtNormal()) continue;
    azimuths.push_back(at.phiI);
    if (!at.isViewerAtNormal()) differences.push_back(at.difference);
  }
  const bool isOneSide = std::ranges::all_of(differences, [](double a) { return a < pi + angleTolerance; });
  // Files round pi.
  if (isOneSide)
    for (double& angle : differences) angle = std::min(angle, pi);
  IncidenceTable table{.axis = IncidenceTable::Axis::normal,
                       .symmetric = isOneSide,
                       .incident = nodesOf(std::move(lights)),
                       .azimuths = nodesOf(std::move(differences)),
                       .polars = nodesOf(std::move(viewers)),
                       .values = {},
                       .rotations = nodesOf(std::move(azimuths))};
  if (table.incident.size() < 3 || table.polars.size() < 3 || table.azimuths.empty()) return std::nullopt;
  const double seam = isOneSide ? std::max(table.azimuths.front(), pi - table.azimuths.back())
                                : table.azimuths.front() + 2 * pi - table.azimuths.back();
  if (std::max(largestStep(table.incident), largestStep(table.polars)) > maxPolarStep ||
      std::max(largestStep(table.azimuths), seam) > maxAzimuthStep)
    return std::nullopt;
  const auto away = [](const std::vector<double>& nodes) {
    return double(nodes.size()) - (nodes[0] > angleTolerance ? 0 : 1);
  };
  if (away(table.incident) * double(table.rotations.size()) * away(table.polars) * double(table.azimuths.size()) >
      double(pairs.size()))
    return std::nullopt;
  if (table.rotations.size() > 1) {
    const double gap = table.rotations.front() + 2 * pi - table.rotations.back();
    if (std::max(largestStep(table.rotations), gap) > maxAzimuthStep) return std::nullopt;
    return table;
  }
  // One azimuth of the light says nothing about the material.
  for (PairAngles& at : pairs) {
    if (at.isLightAtNormal())
      at.difference = positiveAzimuth(std::remainder(at.difference - table.rotations[0], 2 * pi));
    at.phiI = 0;
  }
  table.rotations = {0};
  return table;
}

}  // namespace

std::optional<IncidenceTable> gridOf(const ScatteredSamples& samples) {
  std::vector<PairAngles> pairs;
  pairs.reserve(samples.directions.size());
  for (const DirectionPair& pair : samples.directions) pairs.emplace_back(pair);
  std::optional<IncidenceTable> table = nodesOf(pairs);
  if (!table) return std::nullopt;
  std::map<PairNode, std::pair<Rgb, double>> sums;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto node = nodeOf(*table, pairs[i]);
    if (!node) return std::nullopt;
    auto& [sum, count] = sums.try_emplace(*node, Rgb(0), 0).first->second;
    sum += samples.values[i];
    ++count;
  }
  PairAngles at({{0, 0, 1}, {0, 0, 1}});
  for (const double phiI : table->rotations)
    for (const double thetaI : table->incident)
      for (const double difference : table->azimuths)
        for (const double thetaO : table->polars) {
          at.thetaI = thetaI;
          at.phiI = phiI;
          at.thetaO = thetaO;
          at.difference =
              at.isLightAtNormal() ? positiveAzimuth(std::remainder(difference + phiI, 2 * pi)) : difference;
          const auto node = nodeOf(*table, at);
          const auto found = node ? sums.find(*node) : sums.end();
          if (found == sums.end()) return std::nullopt;
          table->values.emplace_back(found->second.first / found->second.second);
        }
  return table;
}

void setPoints(const ScatteredSamples& samples, const TaskControl& control, materials::Material& material) {
  auto table = gridOf(samples);
  if (!table) return setScattered(samples, control, material);
  material.source.grid = {int(table->incident.size()), int(table->azimuths.size()), int(table->polars.size())};
  if (table->rotations.size() > 1)
    material.source.grid.insert(material.source.grid.begin(), int(table->rotations.size()));
  material.source.description = samples.description;
  std::vector<std::string>& notes = material.source.notes;
  notes.insert(notes.end(), samples.notes.begin(), samples.notes.end());
  notes.push_back("measured on a grid: interpolated between " + std::to_string(table->incident.size()) +
                  " polar angles of the light, " + std::to_string(table->polars.size()) + " of the viewer and " +
                  std::to_string(table->azimuths.size()) + " azimuths between them" +
                  (table->symmetric ? ", the same on both sides of the plane of incidence" : "") +
                  (table->rotations.size() > 1
                       ? ", for " + std::to_string(table->rotations.size()) + " azimuths of the light"
                       : ""));
  addCounts(samples, notes);
  material.brdf = std::make_shared<const IncidenceTableBrdf>(std::move(*table));
}

}  // namespace gonio::formats
