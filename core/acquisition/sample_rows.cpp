// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/sample_rows.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/data_transform.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::acquisition {

namespace {

std::string nameOf(const PlannedSample& sample) { return "sample " + std::to_string(sample.index); }

std::size_t positionOf(const dictionary::MappedCells& mapping, const PlannedSample& sample) {
  const std::uint32_t cell = nodeOf(mapping.grid, sample);
  const auto found = std::lower_bound(mapping.cells.begin(), mapping.cells.end(), cell);
  if (found == mapping.cells.end() || *found != cell)
    throw Error(nameOf(sample) + " lies in a cell without data in the training materials");
  return std::size_t(found - mapping.cells.begin());
}

void checkValue(double value, const PlannedSample& sample, const char* what) {
  if (value >= 0 && value <= maxBrdfValue) return;
  throw Error(nameOf(sample) + ": found " + what + " of " + numberText(value) + ", expected a number from 0 to " +
              numberText(float(maxBrdfValue)) + ", the largest BRDF value");
}

/// @throws Error where a value is so large that its mapped value is infinite.
double mappedValue(double value, const dictionary::MappedCells& mapping, std::size_t position,
                   const PlannedSample& sample) {
  const double mapped = logRelative(value, mapping.weights[position], mapping.reference[position]);
  if (std::isfinite(mapped)) return mapped;
  throw Error(nameOf(sample) + ": found the value " + numberText(value) +
              ", expected a BRDF value with a finite logarithm (neither negative nor too large)");
}

/// Whether two cells are the same or next to each other.
bool areNeighbours(const HalfDifferenceGrid& grid, std::size_t a, std::size_t b) {
  const auto phiCount = std::size_t(grid.phiDCount), thetaDCount = std::size_t(grid.thetaDCount);
  const auto apart = [](std::size_t x, std::size_t y) { return x > y ? x - y : y - x; };
  const std::size_t phi = apart(a % phiCount, b % phiCount);
  return std::min(phi, phiCount - phi) <= 1 && apart(a / phiCount % thetaDCount, b / phiCount % thetaDCount) <= 1 &&
         apart(a / (phiCount * thetaDCount), b / (phiCount * thetaDCount)) <= 1;
}

/// The means of readings that repeat each other (SampleRows).
SampleRows withoutRepetitions(const SampleRows& samples, const HalfDifferenceGrid& grid,
                              const std::vector<std::uint32_t>& cells) {
  constexpr double sameRow = 0.01;
  const auto cellOf = [&](Eigen::Index sample) { return std::size_t(cells[samples.positions[std::size_t(sample)]]); };
  std::vector<std::vector<Eigen::Index>> groups;
  for (Eigen::Index s = 0; s < samples.rows.rows(); ++s) {
    const auto repeated = std::ranges::find_if(groups, [&](const std::vector<Eigen::Index>& group) {
      const Eigen::Index first = group.front();
      return cellOf(s) == cellOf(first) ||
             (areNeighbours(grid, cellOf(s), cellOf(first)) &&
              (samples.rows.row(s) - samples.rows.row(first)).norm() <= sameRow * samples.rows.row(first).norm());
    });
    if (repeated == groups.end())
      groups.push_back({s});
    else
      repeated->push_back(s);
  }
  SampleRows result = samples;
  result.readings = std::size_t(samples.rows.rows());
  if (groups.size() == result.readings) return result;
  const auto count = Eigen::Index(groups.size());
  result.positions.clear();
  result.rows.resize(count, samples.rows.cols());
  result.values.resize(count, 3);
  result.variances.resize(count);
  result.knownNoise.resize(count);
  for (Eigen::Index g = 0; g < count; ++g) {
    const std::vector<Eigen::Index>& group = groups[std::size_t(g)];
    const double number = double(group.size());
    result.positions.push_back(samples.positions[std::size_t(group.front())]);
    result.rows.row(g) = samples.rows(group, Eigen::all).colwise().mean();
    result.values.row(g) = samples.values(group, Eigen::all).colwise().mean();
    // Noise of readings is independent, but the components leave out the same in all of them.
    result.knownNoise[g] = samples.knownNoise(group).mean() / number;
    result.variances[g] = (samples.variances(group) - samples.knownNoise(group)).mean() + result.knownNoise[g];
  }
  return result;
}

}  // namespace

std::uint32_t nodeOf(const HalfDifferenceGrid& grid, const PlannedSample& sample) {
  try {
    return nearestNode(grid, sample.directions);
  } catch (const Error& error) {
    throw Error(nameOf(sample) + ": " + error.what());
  }
}

void checkMeasured(const SamplingPlan& plan, const MeasuredValues& values) {
  const std::size_t count = plan.samples.size();
  if (count == 0) throw Error("the plan contains no samples to reconstruct from");
  if (values.rgb.size() != count || (!values.noise.empty() && values.noise.size() != count))
    throw Error("found " + std::to_string(values.rgb.size()) + " values for a plan of " + std::to_string(count) +
                " samples");
  for (std::size_t s = 0; s < count; ++s)
    for (int channel = 0; channel < 3; ++channel) {
      checkValue(values.rgb[s][channel], plan.samples[s], "a value");
      if (!values.noise.empty()) checkValue(values.noise[s][channel], plan.samples[s], "a standard deviation");
    }
}

SampleRows sampleRows(const dictionary::PrincipalComponents& basis, const SamplingPlan& plan,
                      const MeasuredValues& values, int components) {
  checkMeasured(plan, values);
  const dictionary::MappedCells& m = basis.mapping;
  const auto count = Eigen::Index(plan.samples.size());
  SampleRows result;
  result.rows.resize(count, components);
  result.values.resize(count, 3);
  result.variances.resize(count);
  result.knownNoise.setZero(count);
  for (Eigen::Index s = 0; s < count; ++s) {
    const PlannedSample& sample = plan.samples[std::size_t(s)];
    const std::size_t i = result.positions.emplace_back(positionOf(m, sample));
    result.rows.row(s) = basis.svd.u.view()
                             .row(Eigen::Index(i))
                             .head(components)
                             .cast<double>()
                             .cwiseProduct(basis.svd.singularValues.head(components).transpose());
    result.variances[s] = leftOutVariance(basis, components, i, i + 1)[0];
    for (int channel = 0; channel < 3; ++channel) {
      const double rho = values.rgb[std::size_t(s)][channel];
      result.values(s, channel) = mappedValue(rho, m, i, sample) - basis.mean[i];
      if (values.noise.empty()) continue;
      const double deviation = values.noise[std::size_t(s)][channel];
      // d y / d rho = w / (rho w + e).
      const double mapped = deviation * m.weights[i] / (rho * m.weights[i] + logRelativeOffset);
      result.knownNoise[s] += mapped * mapped / 3;
    }
    result.variances[s] += result.knownNoise[s];
  }
  return withoutRepetitions(result, m.grid, m.cells);
}

}  // namespace gonio::acquisition
