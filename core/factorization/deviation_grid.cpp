// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/deviation_grid.h"

#include <algorithm>
#include <cmath>

#include "core/coordinates/projected_deviation.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

constexpr std::size_t steps = 2000;
constexpr double evenShare = 1.0 / 3;
constexpr int viewers = 30, azimuths = 8;

enum class AzimuthCount { same, onDisk };

/// Sum of ln(1 + rho) over viewers, azimuths on the disk, and channels, at one deviation. A sum, not a mean: deviations
/// with few valid pairs get few nodes. @param counted whether the weight of each viewer is the same number of azimuths,
/// or the part of the circle that is on the disk.
double energyAt(const Brdf& brdf, double deviation, AzimuthCount counted) {
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  for (int i = 0; i < viewers; ++i) {
    const double thetaR = halfPi * i / viewers, limit = azimuthLimit(deviation, std::sin(thetaR));
    for (int k = 0; k < azimuths && limit > 0; ++k) {
      const auto at = fromProjectedDeviation({thetaR, deviation, limit * (k + 0.5) / azimuths});
      if (!at.valid) continue;
      pairs.push_back(at.pair);
      weights.push_back(counted == AzimuthCount::onDisk ? limit / pi : 1);
    }
  }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) sum += weights[i] * std::log1p(std::max(0.0, values[i][channel]));
  return sum;
}

/// Adds the energy of a material at every step.
void addEnergy(std::vector<double>& energy, const Brdf& brdf, AzimuthCount counted, const TaskControl& control) {
  parallelForBlocks(
      steps, 50,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j)
          energy[j] += energyAt(brdf, (double(j) + 0.5) * maxDeviation / steps, counted);
      },
      control);
}

}  // namespace

std::vector<double> deviationNodes(std::span<const double> energy, int count) {
  constexpr double smallestGap = 1e-6;
  std::vector<double> cumulative{0};
  for (const double e : energy) cumulative.push_back(cumulative.back() + e);
  const double total = cumulative.back(), step = maxDeviation / double(energy.size());
  std::vector<double> nodes;
  std::size_t at = 0;
  for (int k = 0; k < count; ++k) {
    const double fraction = double(k) / (count - 1);
    double node = maxDeviation * fraction;
    if (total > 0) {
      const double wanted = fraction * total;
      while (at + 1 < energy.size() && cumulative[at + 1] < wanted) ++at;
      const double part = energy[at] > 0 ? (wanted - cumulative[at]) / energy[at] : 0;
      node = step * (double(at) + std::clamp(part, 0.0, 1.0));
    }
    nodes.push_back(nodes.empty() ? 0 : std::max(node, nodes.back() + smallestGap));
  }
  nodes.back() = maxDeviation;
  for (std::size_t k = nodes.size() - 1; k-- > 1;) nodes[k] = std::min(nodes[k], nodes[k + 1] - smallestGap);
  return nodes;
}

std::vector<double> deviationNodes(std::span<const std::shared_ptr<const TabulatedBrdf>> tables, int count,
                                   const TaskControl& control) {
  std::vector<double> energy(steps, 0.0);
  for (const auto& table : tables) addEnergy(energy, *table, AzimuthCount::same, control);
  double total = 0;
  for (const double e : energy) total += e;
  for (double& e : energy) e = (1 - evenShare) * e + evenShare * total / double(steps);
  return deviationNodes(energy, count);
}

std::vector<double> publishedDeviationEnergy(const Brdf& brdf, const TaskControl& control) {
  std::vector<double> energy(steps, 0.0);
  addEnergy(energy, brdf, AzimuthCount::onDisk, control);
  return energy;
}

}  // namespace gonio::factorization
