// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/rivals/half_out_samples.h"

#include <algorithm>
#include <cmath>

#include "core/coordinates/half_out.h"
#include "core/factorization/deviation_grid.h"
#include "core/factorization/rivals/node_spacing.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

/// The last nodes stand on the limit itself.
const double smallestCosine = std::cos(largestPolarAngle) * (1 - 1e-9);

std::vector<double> powerNodes(int count, double last, double exponent) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(last * std::pow(double(i) / (count - 1), exponent));
  return nodes;
}

bool sampleNode(const TabulatedBrdf& table, const HalfOut& node, Rgb& value, double& cosI) {
  const HalfOutDirections at = fromHalfOut(node);
  if (!at.valid || at.pair.wi.z < smallestCosine) return false;
  double count = 0;
  for (const double side : {1.0, -1.0}) {
    bool measured = false;
    const Direction wi(at.pair.wi.x, side * at.pair.wi.y, at.pair.wi.z);
    const Rgb rho = table.lookup(toHalfDifference(wi, at.pair.wo), TableLookup::trilinear, &measured);
    if (!measured) continue;
    value += rho;
    ++count;
  }
  if (count == 0) return false;
  value /= count;
  cosI = at.pair.wi.z;
  return true;
}

}  // namespace

HalfOutAxes makeHalfOutAxes(int thetaHCount, int phiHCount, int thetaOCount) {
  return {.thetaH = powerNodes(thetaHCount, largestPolarAngle, 2),
          .phiH = powerNodes(phiHCount, pi, 1),
          .thetaO = powerNodes(thetaOCount, largestPolarAngle, 1)};
}

HalfOutSamples sampleHalfOut(const TabulatedBrdf& table, const HalfOutAxes& axes, const TaskControl& control) {
  HalfOutSamples samples{.axes = axes,
                         .values = std::vector<Rgb>(axes.size(), Rgb(0)),
                         .cosI = std::vector<double>(axes.size(), 0),
                         .valid = std::vector<std::uint8_t>(axes.size(), 0)};
  parallelForBlocks(axes.thetaH.size(), 1,
                    [&](std::size_t h, std::size_t) {
                      for (std::size_t p = 0; p < axes.phiH.size(); ++p)
                        for (std::size_t o = 0; o < axes.thetaO.size(); ++o) {
                          const std::size_t i = axes.index(h, p, o);
                          const HalfOut node{.thetaO = axes.thetaO[o], .thetaH = axes.thetaH[h], .phiH = axes.phiH[p]};
                          samples.valid[i] = sampleNode(table, node, samples.values[i], samples.cosI[i]);
                        }
                    },
                    {.stop = control.stop});
  return samples;
}

double projectedMeasure(const HalfOutSamples& samples, std::size_t h, std::size_t p, std::size_t o) {
  const HalfOutAxes& axes = samples.axes;
  const std::size_t i = axes.index(h, p, o);
  if (!samples.valid[i]) return 0;
  const double thetaO = axes.thetaO[o], thetaH = axes.thetaH[h];
  const double cosD = glm::dot(fromSpherical(thetaO, 0), fromSpherical(thetaH, axes.phiH[p]));
  return samples.cosI[i] * std::cos(thetaO) * std::sin(thetaO) * std::sin(thetaH) * halfOutMeasure(cosD) *
         nodeSpacing(axes.thetaH, h) * nodeSpacing(axes.phiH, p) * nodeSpacing(axes.thetaO, o);
}

}  // namespace gonio::factorization
