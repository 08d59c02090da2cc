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
  if (samples.belowHorizonCount > 0)
    notes.push_back(count(samples.belowHorizonCount) + " samples at or below the horizon were left out");
  if (samples.clampedCount > 0) notes.push_back(count(samples.clampedCount) + " negative values were set to 0");
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

AngleUnit AngleUnit::guessed(std::span<const std::array<double, 4>> angles, const std::string& choice) {
  constexpr double rounding = 0.01;  // of angles with few digits
  constexpr AngleUnit inDegrees{gonio::radians(1), "degrees"};
  double largest = 0, polar = 0, fraction = 0;
  for (const std::array<double, 4>& row : angles)
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double angle = std::abs(row[i]), steps = angle / (pi / 12);
      largest = std::max(largest, angle);
      if (i % 2 == 0) polar = std::max(polar, angle);
      // Four digits or more of a multiple of 15 degrees.
      if (angle > rounding && std::abs(steps - std::round(steps)) < 4e-4) fraction = angle;
    }
  if (largest > 2 * pi + rounding || polar > pi + rounding) return inDegrees;
  if (!(polar > halfPi + rounding)) return {};
  if (!(fraction > 0)) return inDegrees;
  throw Error("found the polar angle " + numberText(polar) + ", which in radians is below the horizon, and the angle " +
              numberText(fraction) + ", which looks like radians; expected angles in a known unit: " + choice);
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

}  // namespace gonio::formats
