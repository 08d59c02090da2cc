// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/factorization/node_samples.h"

namespace gonio::factorization {

/// Nodes in half-out coordinates (core/coordinates/half_out.h), rad, each strictly increasing from 0.
struct HalfOutAxes {
  std::vector<double> thetaH;
  std::vector<double> phiH;  ///< of |phi_h|, to pi
  std::vector<double> thetaO;

  std::size_t size() const { return thetaH.size() * phiH.size() * thetaO.size(); }
  /// thetaO runs fastest, thetaH slowest.
  std::size_t index(std::size_t h, std::size_t p, std::size_t o) const {
    return (h * phiH.size() + p) * thetaO.size() + o;
  }
};

/// Axes with theta_h dense at the highlight as in MERL tables, the others even; polar angles up to largestPolarAngle.
HalfOutAxes makeHalfOutAxes(int thetaHCount, int phiHCount, int thetaOCount);

/// BRDF values at all nodes: the mean of phi_h and -phi_h.
using HalfOutSamples = NodeSamples<HalfOutAxes>;

/// About 0.1 s for 200,000 nodes. @throws Cancelled.
HalfOutSamples sampleHalfOut(const TabulatedBrdf& table, const HalfOutAxes& axes, const TaskControl& control = {});

/// Measure of the cell at a node in both projected solid angles (theta_o, half vector), up to a constant; 0 where
/// invalid: the weight of a squared error as light transport sees it.
double projectedMeasure(const HalfOutSamples& samples, std::size_t h, std::size_t p, std::size_t o);

}  // namespace gonio::factorization
