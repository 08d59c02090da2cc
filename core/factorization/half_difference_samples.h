// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/factorization/node_samples.h"

namespace gonio::factorization {

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
