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
  if (std::isfinite(value) && value >= 0) return;
  throw Error(nameOf(sample) + ": found " + what + " of " + numberText(value) + ", expected a number, 0 or more");
}

/// @throws Error where a value is so large that its mapped value is infinite.
double mappedValue(double value, const dictionary::MappedCells& mapping, std::size_t position,
                   const PlannedSample& sample) {
  const double mapped = logRelative(value, mapping.weights[position], mapping.reference[position]);
  if (std::isfinite(mapped)) return mapped;
  throw Error(nameOf(sample) + ": found the value " + numberText(value) +
              ", expected a BRDF value with a finite logarithm (neither negative nor too large)");
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
  return result;
}

}  // namespace gonio::acquisition
