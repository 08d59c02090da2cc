// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/factorization/node_samples.h"

namespace gonio::factorization {

/// Nodes in half-difference coordinates, rad, each strictly increasing from 0.
struct HalfDifferenceAxes {
  std::vector<double> thetaH, thetaD;
  std::vector<double> phiD;  ///< to pi / 2: the rest follows from reciprocity and the plane of incidence

  std::size_t size() const { return thetaH.size() * thetaD.size() * phiD.size(); }
  /// phiD runs fastest, thetaH slowest.
  std::size_t index(std::size_t h, std::size_t d, std::size_t p) const {
    return (h * thetaD.size() + d) * phiD.size() + p;
  }
};

/// Axes with the polar nodes of a MERL table of that many, phi_d even with both ends.
HalfDifferenceAxes makeHalfDifferenceAxes(int thetaHCount, int thetaDCount, int phiDCount);

/// BRDF values at all nodes, for models that are reciprocal and symmetric about the plane of incidence: the mean of
/// phi_d, -phi_d and their opposites.
using HalfDifferenceSamples = NodeSamples<HalfDifferenceAxes>;

/// About 0.1 s for 150,000 nodes. @throws Cancelled.
HalfDifferenceSamples sampleHalfDifference(const TabulatedBrdf& table, const HalfDifferenceAxes& axes,
                                           const TaskControl& control = {});

/// Measure of the cell at a node in both projected solid angles, up to a constant; 0 where invalid: the weight of a
/// squared error as light transport sees it.
double projectedMeasure(const HalfDifferenceSamples& samples, std::size_t h, std::size_t d, std::size_t p);

}  // namespace gonio::factorization
