// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/factorization/half_difference_samples.h"

/// What the tests of the baselines in half-difference coordinates share.
namespace gonio::factorization::test_support {

/// Calls visit(h, d, p, index, directions) for the nodes with both directions above the horizon.
template <typename Visit>
void visitNodes(const HalfDifferenceAxes& axes, const Visit& visit) {
  for (std::size_t h = 0; h < axes.thetaH.size(); ++h)
    for (std::size_t d = 0; d < axes.thetaD.size(); ++d)
      for (std::size_t p = 0; p < axes.phiD.size(); ++p) {
        const DirectionPair at = fromHalfDifference(axes.thetaH[h], axes.thetaD[d], axes.phiD[p]);
        if (std::min(at.wi.z, at.wo.z) > 0.02) visit(h, d, p, axes.index(h, d, p), at);
      }
}

/// Samples of any function of a pair at the nodes.
inline HalfDifferenceSamples halfDifferenceSamples(
    const HalfDifferenceAxes& axes, const std::function<Rgb(const HalfDifference&, const DirectionPair&)>& rho) {
  HalfDifferenceSamples s = emptySamples(axes);
  visitNodes(axes, [&](std::size_t h, std::size_t d, std::size_t p, std::size_t i, const DirectionPair& at) {
    s.valid[i] = 1;
    s.cosI[i] = at.wi.z;
    s.cosO[i] = at.wo.z;
    s.values[i] = rho({.thetaH = axes.thetaH[h], .thetaD = axes.thetaD[d], .phiD = axes.phiD[p]}, at);
  });
  return s;
}

/// Largest difference of a BRDF from the samples at the valid nodes, relative to the largest sample of the channel.
inline double worstAtNodes(const HalfDifferenceSamples& s, const Brdf& brdf) {
  Rgb largest(1e-6);
  for (const Rgb& value : s.values) largest = glm::max(largest, value);
  double worst = 0;
  visitNodes(s.axes, [&](std::size_t, std::size_t, std::size_t, std::size_t i, const DirectionPair& at) {
    const Rgb error = glm::abs(brdf.evaluate(at.wi, at.wo) - s.values[i]) / largest;
    worst = std::max(worst, maxChannel(error));
  });
  return worst;
}

}  // namespace gonio::factorization::test_support
