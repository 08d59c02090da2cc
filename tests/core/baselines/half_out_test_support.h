// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <functional>

#include "core/baselines/half_vector_sampler.h"
#include "core/coordinates/half_out.h"

/// What the tests of the baselines in half-out coordinates share.
namespace gonio::factorization::test_support {

/// Nodes that all have a light above the horizon: no holes.
inline baselines::HalfOutAxes axesWithoutHorizon() {
  baselines::HalfOutAxes axes = baselines::makeHalfOutAxes(12, 8, 9);
  for (double& theta : axes.thetaH) theta *= 0.3;
  for (double& theta : axes.thetaO) theta *= 0.3;
  return axes;
}

/// Samples of any function of (theta_h, |phi_h|, theta_o) at nodes that have a light above the horizon.
inline baselines::HalfOutSamples halfOutSamples(
    const baselines::HalfOutAxes& axes,
    const std::function<Rgb(double thetaH, double phiH, double thetaO, double cosI)>& rho) {
  baselines::HalfOutSamples s = emptySamples(axes);
  for (std::size_t h = 0; h < axes.thetaH.size(); ++h)
    for (std::size_t p = 0; p < axes.phiH.size(); ++p)
      for (std::size_t o = 0; o < axes.thetaO.size(); ++o) {
        const HalfOut node{.thetaO = axes.thetaO[o], .thetaH = axes.thetaH[h], .phiH = axes.phiH[p]};
        const HalfOutDirections at = fromHalfOut(node);
        const std::size_t i = axes.index(h, p, o);
        s.valid[i] = at.valid && at.pair.wi.z > 0.02;
        if (!s.valid[i]) continue;
        s.cosI[i] = at.pair.wi.z;
        s.values[i] = rho(node.thetaH, node.phiH, node.thetaO, at.pair.wi.z);
      }
  return s;
}

/// Largest relative difference of a BRDF from the samples at the valid nodes.
inline double worstAtNodes(const baselines::HalfOutSamples& s, const Brdf& brdf) {
  double worst = 0;
  for (std::size_t h = 0; h < s.axes.thetaH.size(); ++h)
    for (std::size_t p = 0; p < s.axes.phiH.size(); ++p)
      for (std::size_t o = 0; o < s.axes.thetaO.size(); ++o) {
        const std::size_t i = s.axes.index(h, p, o);
        // At the pole of the half vector and at the normal azimuths fall together.
        if (!s.valid[i] || ((h == 0 || o == 0) && p > 0)) continue;
        const DirectionPair at =
            fromHalfOut({.thetaO = s.axes.thetaO[o], .thetaH = s.axes.thetaH[h], .phiH = s.axes.phiH[p]}).pair;
        const Rgb found = brdf.evaluate(at.wi, at.wo);
        for (int c = 0; c < 3; ++c)
          worst = std::max(worst, std::abs(found[c] - s.values[i][c]) / std::max(s.values[i][c], 1e-3));
      }
  return worst;
}

}  // namespace gonio::factorization::test_support
