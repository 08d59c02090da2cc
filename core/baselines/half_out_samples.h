// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/factorization/half_difference_samples.h"

namespace gonio::factorization {

/// Nodes in half-out coordinates (core/coordinates/half_out.h), rad, each strictly increasing from 0.
struct HalfOutAxes {
  std::vector<double> thetaH;
  std::vector<double> phiH;  ///< of |phi_h|, up to pi
  std::vector<double> thetaO;

  std::size_t size() const { return thetaH.size() * phiH.size() * thetaO.size(); }
  /// thetaO runs fastest, thetaH slowest.
  std::size_t index(std::size_t h, std::size_t p, std::size_t o) const {
    return (h * phiH.size() + p) * thetaO.size() + o;
  }
};

/// Axes with theta_h dense at the highlight, as in MERL tables, and the other angles uniform; polar angles up to
/// maxPolarAngle (core/factorization/deviation_grid.h).
HalfOutAxes makeHalfOutAxes(int thetaHCount, int phiHCount, int thetaOCount);

/// BRDF values at all nodes: the mean of the values at phi_h and -phi_h.
using HalfOutSamples = NodeSamples<HalfOutAxes>;

/// About 0.1 s for 200,000 nodes. @throws Cancelled.
HalfOutSamples sampleHalfOut(const TabulatedBrdf& table, const HalfOutAxes& axes, const TaskControl& control = {});

/// Weight of a node's squared error in light transport: the measure of its cell in projected solid angles of light and
/// viewer, up to a constant; 0 if invalid.
double projectedMeasure(const HalfOutSamples& samples, std::size_t h, std::size_t p, std::size_t o);

}  // namespace gonio::factorization
