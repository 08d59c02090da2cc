// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/grid_directions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gonio {

namespace {

constexpr int stepBits = 4;
constexpr std::size_t scatteredSteps = 1 << stepBits;
/// 2^64 / g, 2^64 / g^2 and 2^64 / g^3.
constexpr std::uint64_t multipliers[] = {0xd1b54a32d192ed03, 0xabc98388fb8fac03, 0x8cb92ba72f3d8dd7};

std::size_t stepOf(std::size_t node, std::size_t axis) {
  return std::size_t((std::uint64_t(node) * multipliers[axis]) >> (64 - stepBits));
}

}  // namespace

GridDirections::GridDirections(const HalfDifferenceGrid& grid, GridPoints points)
    : steps_(points == GridPoints::nodes ? 1 : scatteredSteps),
      thetaDCount_(std::size_t(grid.thetaDCount)),
      phiCount_(std::size_t(grid.phiDCount)) {
  const auto add = [](std::vector<SineCosine>& list, double angle) {
    list.push_back({std::sin(angle), std::cos(angle)});
  };
  if (points == GridPoints::nodes) {
    for (int i = 0; i < grid.thetaHCount; ++i) add(thetaH_, grid.node(grid.index(i, 0, 0)).thetaH);
    for (int j = 0; j < grid.thetaDCount; ++j) add(thetaD_, grid.node(grid.index(0, j, 0)).thetaD);
    for (int k = 0; k < grid.phiDCount; ++k) add(phiD_, grid.node(grid.index(0, 0, k)).phiD);
    return;
  }
  // Cells extend half a step to each side of their node, those at the ends of theta_h and theta_d to the end.
  const auto polarPosition = [this](int node, int count, std::size_t step) {
    const double low = std::max(0.0, node - 0.5), high = node + 1 == count ? count : node + 0.5;
    return (low + (high - low) * (double(step) + 0.5) / double(steps_)) / count;
  };
  for (std::size_t step = 0; step < steps_ * std::size_t(grid.thetaHCount); ++step) {
    const double position = polarPosition(int(step / steps_), grid.thetaHCount, step % steps_);
    add(thetaH_, position * position * halfPi);
  }
  for (std::size_t step = 0; step < steps_ * thetaDCount_; ++step)
    add(thetaD_, polarPosition(int(step / steps_), grid.thetaDCount, step % steps_) * halfPi);
  for (int k = 0; k < grid.phiDCount; ++k) add(phiD_, grid.node(grid.index(0, 0, k)).phiD);
  for (std::size_t step = 0; step < steps_; ++step)
    add(phiDSteps_, ((double(step) + 0.5) / double(steps_) - 0.5) / grid.phiDCount * grid.phiDPeriod());
}

GridDirections::Node GridDirections::at(std::size_t index) const {
  const std::size_t row = index / phiCount_, k = index % phiCount_;
  std::size_t i = row / thetaDCount_, j = row % thetaDCount_;
  SineCosine f = phiD_[k];
  if (steps_ > 1) {
    const bool isMirrored = 2 * k > phiCount_;
    const std::size_t node = isMirrored ? index - k + (phiCount_ - k) : index;
    i = i * steps_ + stepOf(node, 0);
    j = j * steps_ + stepOf(node, 1);
    // The sum of two angles: a list of all would leave the near caches.
    const SineCosine s = phiDSteps_[isMirrored ? steps_ - 1 - stepOf(node, 2) : stepOf(node, 2)];
    f = {f.sine * s.cosine + f.cosine * s.sine, f.cosine * s.cosine - f.sine * s.sine};
  }
  const SineCosine &h = thetaH_[i], &d = thetaD_[j];
  Node node{fromHalfDifference(h.sine, h.cosine, d.sine, d.cosine, f.sine, f.cosine),
            isAboveHorizon(h.sine, h.cosine, d.sine, d.cosine, f.cosine)};
  if (node.aboveHorizon) {
    // Rounding alone leaves horizontal directions a little below.
    node.pair.wi.z = std::max(0.0, node.pair.wi.z);
    node.pair.wo.z = std::max(0.0, node.pair.wo.z);
  }
  return node;
}

}  // namespace gonio
