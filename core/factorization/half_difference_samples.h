// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/factorization/deviation_grid.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

/// BRDF values at the nodes of `Axes`, which has three vectors of nodes (one of them thetaH), the total number size(),
/// and index() with theta_h slowest.
template <typename Axes>
struct NodeSamples {
  Axes axes;
  std::vector<Rgb> values;          ///< 1/sr, without the cosine; 0 where invalid
  std::vector<double> cosI, cosO;   ///< cosines of the two polar angles; 0 where invalid
  std::vector<std::uint8_t> valid;  ///< 0 where a direction is beyond maxPolarAngle or the table has no data
};

/// Samples of which none is valid.
template <typename Axes>
NodeSamples<Axes> emptySamples(const Axes& axes) {
  return {.axes = axes,
          .values = std::vector<Rgb>(axes.size(), Rgb(0)),
          .cosI = std::vector<double>(axes.size(), 0),
          .cosO = std::vector<double>(axes.size(), 0),
          .valid = std::vector<std::uint8_t>(axes.size(), 0)};
}

/// The directions of a node, and the coordinates at which the table is read; the sample is the mean of the readings.
template <std::size_t Readings>
struct NodeReadings {
  DirectionPair pair;
  std::array<HalfDifference, Readings> at;
  bool valid = true;
};

/// Samples a table. @param secondCount, thirdCount numbers of nodes of the second and third axis. @param readingsOf
/// callable with the indices on the three axes (theta_h first), returns NodeReadings. @throws Cancelled.
template <typename Axes, typename ReadingsOf>
NodeSamples<Axes> sampleNodes(const TabulatedBrdf& table, const Axes& axes, std::size_t secondCount,
                              std::size_t thirdCount, const ReadingsOf& readingsOf, const TaskControl& control) {
  // The last nodes lie exactly on the limit.
  const double minCosine = std::cos(maxPolarAngle) * (1 - 1e-9);
  NodeSamples<Axes> samples = emptySamples(axes);
  const auto sampleNode = [&](std::size_t i, const auto& node) {
    if (!node.valid || node.pair.wi.z < minCosine || node.pair.wo.z < minCosine) return;
    Rgb sum(0);
    double count = 0;
    for (const HalfDifference& at : node.at) {
      bool measured = false;
      const Rgb rho = table.lookup(at, TableLookup::trilinear, &measured);
      if (!measured) continue;
      sum += rho;
      ++count;
    }
    if (count == 0) return;
    samples.values[i] = sum / count;
    samples.cosI[i] = node.pair.wi.z;
    samples.cosO[i] = node.pair.wo.z;
    samples.valid[i] = 1;
  };
  parallelForBlocks(axes.thetaH.size(), 1,
                    [&](std::size_t h, std::size_t) {
                      for (std::size_t s = 0; s < secondCount; ++s)
                        for (std::size_t t = 0; t < thirdCount; ++t)
                          sampleNode(axes.index(h, s, t), readingsOf(h, s, t));
                    },
                    {.stop = control.stop});
  return samples;
}

/// Bounds of a node's cell: half way to its neighbours, or the node itself at the ends.
inline std::pair<double, double> nodeCell(const std::vector<double>& nodes, std::size_t i) {
  return {(nodes[i == 0 ? 0 : i - 1] + nodes[i]) / 2, (nodes[i] + nodes[std::min(i + 1, nodes.size() - 1)]) / 2};
}

inline double nodeSpacing(const std::vector<double>& nodes, std::size_t i) {
  const auto [begin, end] = nodeCell(nodes, i);
  return end - begin;
}

/// Solid angle of a polar node's cell per radian of azimuth, sr/rad.
inline double solidAngle(const std::vector<double>& nodes, std::size_t i) {
  const auto [begin, end] = nodeCell(nodes, i);
  return std::cos(begin) - std::cos(end);
}

/// Nodes in half-difference coordinates, rad, each strictly increasing from 0.
struct HalfDifferenceAxes {
  std::vector<double> thetaH, thetaD;
  std::vector<double> phiD;  ///< up to pi/2; other azimuths follow from reciprocity and mirror symmetry

  std::size_t size() const { return thetaH.size() * thetaD.size() * phiD.size(); }
  /// phiD runs fastest, thetaH slowest.
  std::size_t index(std::size_t h, std::size_t d, std::size_t p) const {
    return (h * thetaD.size() + d) * phiD.size() + p;
  }
};

/// Axes with the nodes of a MERL table with that many polar nodes, and phi_d uniform in [0, pi/2] with both ends.
HalfDifferenceAxes makeHalfDifferenceAxes(int thetaHCount, int thetaDCount, int phiDCount);

/// BRDF values at all nodes, for models that are reciprocal and symmetric about the plane of incidence: the mean of the
/// values at phi_d, -phi_d, phi_d + pi and pi - phi_d.
using HalfDifferenceSamples = NodeSamples<HalfDifferenceAxes>;

/// About 0.1 s for 150,000 nodes. @throws Cancelled.
HalfDifferenceSamples sampleHalfDifference(const TabulatedBrdf& table, const HalfDifferenceAxes& axes,
                                           const TaskControl& control = {});

/// Weight of a node's squared error in light transport: the measure of its cell in projected solid angles of light and
/// viewer, up to a constant; 0 if invalid.
double projectedMeasure(const HalfDifferenceSamples& samples, std::size_t h, std::size_t d, std::size_t p);

}  // namespace gonio::factorization
