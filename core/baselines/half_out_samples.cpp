// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/half_out_samples.h"

#include <cmath>

#include "core/coordinates/half_out.h"

namespace gonio::factorization {

namespace {

std::vector<double> powerNodes(int count, double last, double exponent) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(last * std::pow(double(i) / (count - 1), exponent));
  return nodes;
}

}  // namespace

HalfOutAxes makeHalfOutAxes(int thetaHCount, int phiHCount, int thetaOCount) {
  return {.thetaH = powerNodes(thetaHCount, maxPolarAngle, 2),
          .phiH = powerNodes(phiHCount, pi, 1),
          .thetaO = powerNodes(thetaOCount, maxPolarAngle, 1)};
}

HalfOutSamples sampleHalfOut(const TabulatedBrdf& table, const HalfOutAxes& axes, const TaskControl& control) {
  const auto readingsOf = [&](std::size_t h, std::size_t p, std::size_t o) {
    const auto [pair, valid] = fromHalfOut({.thetaO = axes.thetaO[o], .thetaH = axes.thetaH[h], .phiH = axes.phiH[p]});
    const Direction mirrored(pair.wi.x, -pair.wi.y, pair.wi.z);
    return NodeReadings<2>{
        .pair = pair, .at = {toHalfDifference(pair.wi, pair.wo), toHalfDifference(mirrored, pair.wo)}, .valid = valid};
  };
  return sampleNodes(table, axes, axes.phiH.size(), axes.thetaO.size(), readingsOf, control);
}

double projectedMeasure(const HalfOutSamples& samples, std::size_t h, std::size_t p, std::size_t o) {
  const HalfOutAxes& axes = samples.axes;
  const std::size_t i = axes.index(h, p, o);
  if (!samples.valid[i]) return 0;
  const double thetaO = axes.thetaO[o], thetaH = axes.thetaH[h];
  const double cosD = glm::dot(fromSpherical(thetaO, 0), fromSpherical(thetaH, axes.phiH[p]));
  return samples.cosI[i] * std::cos(thetaO) * std::sin(thetaO) * std::sin(thetaH) * halfOutJacobian(cosD) *
         nodeSpacing(axes.thetaH, h) * nodeSpacing(axes.phiH, p) * nodeSpacing(axes.thetaO, o);
}

}  // namespace gonio::factorization
