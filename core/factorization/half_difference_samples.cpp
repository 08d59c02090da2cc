// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/half_difference_samples.h"

#include <cmath>

namespace gonio::factorization {

HalfDifferenceAxes makeHalfDifferenceAxes(int thetaHCount, int thetaDCount, int phiDCount) {
  HalfDifferenceAxes axes;
  for (int i = 0; i < thetaHCount; ++i) axes.thetaH.push_back(halfPi * std::pow(double(i) / thetaHCount, 2));
  for (int i = 0; i < thetaDCount; ++i) axes.thetaD.push_back(halfPi * i / thetaDCount);
  for (int i = 0; i < phiDCount; ++i) axes.phiD.push_back(halfPi * i / (phiDCount - 1));
  return axes;
}

HalfDifferenceSamples sampleHalfDifference(const TabulatedBrdf& table, const HalfDifferenceAxes& axes,
                                           const TaskControl& control) {
  const auto readingsOf = [&](std::size_t h, std::size_t d, std::size_t p) {
    const double thetaH = axes.thetaH[h], thetaD = axes.thetaD[d], phiD = axes.phiD[p];
    const auto at = [&](double phi) { return HalfDifference{.thetaH = thetaH, .thetaD = thetaD, .phiD = phi}; };
    return NodeReadings<4>{.pair = fromHalfDifference(thetaH, thetaD, phiD),
                           .at = {at(phiD), at(-phiD), at(pi - phiD), at(phiD - pi)}};
  };
  return sampleNodes(table, axes, axes.thetaD.size(), axes.phiD.size(), readingsOf, control);
}

double projectedMeasure(const HalfDifferenceSamples& samples, std::size_t h, std::size_t d, std::size_t p) {
  const HalfDifferenceAxes& axes = samples.axes;
  const std::size_t i = axes.index(h, d, p);
  if (!samples.valid[i]) return 0;
  return samples.cosI[i] * samples.cosO[i] * solidAngle(axes.thetaH, h) * solidAngle(axes.thetaD, d) *
         std::cos(axes.thetaD[d]) * nodeSpacing(axes.phiD, p);
}

}  // namespace gonio::factorization
