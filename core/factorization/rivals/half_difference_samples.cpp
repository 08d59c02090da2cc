// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/rivals/half_difference_samples.h"

#include <cmath>

#include "core/factorization/deviation_grid.h"
#include "core/factorization/rivals/node_spacing.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

/// The last nodes stand on the limit itself.
const double smallestCosine = std::cos(largestPolarAngle) * (1 - 1e-9);

bool sampleNode(const TabulatedBrdf& table, double thetaH, double thetaD, double phiD, Rgb& value) {
  double count = 0;
  for (const double phi : {phiD, -phiD, pi - phiD, phiD - pi}) {
    bool measured = false;
    const Rgb rho = table.lookup({.thetaH = thetaH, .thetaD = thetaD, .phiD = phi}, TableLookup::trilinear, &measured);
    if (!measured) continue;
    value += rho;
    ++count;
  }
  if (count > 0) value /= count;
  return count > 0;
}

}  // namespace

HalfDifferenceAxes makeHalfDifferenceAxes(int thetaHCount, int thetaDCount, int phiDCount) {
  HalfDifferenceAxes axes;
  for (int i = 0; i < thetaHCount; ++i) axes.thetaH.push_back(halfPi * std::pow(double(i) / thetaHCount, 2));
  for (int i = 0; i < thetaDCount; ++i) axes.thetaD.push_back(halfPi * i / thetaDCount);
  for (int i = 0; i < phiDCount; ++i) axes.phiD.push_back(halfPi * i / (phiDCount - 1));
  return axes;
}

HalfDifferenceSamples sampleHalfDifference(const TabulatedBrdf& table, const HalfDifferenceAxes& axes,
                                           const TaskControl& control) {
  HalfDifferenceSamples samples{.axes = axes,
                                .values = std::vector<Rgb>(axes.size(), Rgb(0)),
                                .cosI = std::vector<double>(axes.size(), 0),
                                .cosO = std::vector<double>(axes.size(), 0),
                                .valid = std::vector<std::uint8_t>(axes.size(), 0)};
  parallelForBlocks(axes.thetaH.size(), 1,
                    [&](std::size_t h, std::size_t) {
                      for (std::size_t d = 0; d < axes.thetaD.size(); ++d)
                        for (std::size_t p = 0; p < axes.phiD.size(); ++p) {
                          const double thetaH = axes.thetaH[h], thetaD = axes.thetaD[d], phiD = axes.phiD[p];
                          const DirectionPair at = fromHalfDifference(thetaH, thetaD, phiD);
                          if (at.wi.z < smallestCosine || at.wo.z < smallestCosine) continue;
                          const std::size_t i = axes.index(h, d, p);
                          if (!sampleNode(table, thetaH, thetaD, phiD, samples.values[i])) continue;
                          samples.valid[i] = 1;
                          samples.cosI[i] = at.wi.z;
                          samples.cosO[i] = at.wo.z;
                        }
                    },
                    {.stop = control.stop});
  return samples;
}

double projectedMeasure(const HalfDifferenceSamples& samples, std::size_t h, std::size_t d, std::size_t p) {
  const HalfDifferenceAxes& axes = samples.axes;
  const std::size_t i = axes.index(h, d, p);
  if (!samples.valid[i]) return 0;
  return samples.cosI[i] * samples.cosO[i] * solidAngle(axes.thetaH, h) * solidAngle(axes.thetaD, d) *
         std::cos(axes.thetaD[d]) * nodeSpacing(axes.phiD, p);
}

}  // namespace gonio::factorization
