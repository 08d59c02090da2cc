// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/section.h"

#include <algorithm>
#include <limits>

#include "core/coordinates/half_difference.h"
#include "core/plots/angle_nodes.h"

namespace gonio::plots {

namespace {

constexpr double end = halfPi - horizonMargin;

std::vector<double> anglesOf(const Section& section) {
  switch (section.axis) {
    case SectionAxis::thetaH:
      return nodesAbout(0, 0, end, section.count);
    case SectionAxis::thetaD:
      return nodesAbout(halfPi, 0, end, section.count, 8);
    case SectionAxis::thetaO:
      break;
  }
  return nodesAbout(section.thetaI, -end, end, section.count);
}

DirectionPair pairAt(const Section& section, double angle) {
  switch (section.axis) {
    case SectionAxis::thetaH:
      return fromHalfDifference(angle, section.thetaD, section.phiD);
    case SectionAxis::thetaD:
      return fromHalfDifference(section.thetaH, angle, section.phiD);
    case SectionAxis::thetaO:
      break;
  }
  return {fromSpherical(section.thetaI, pi), fromSpherical(angle, section.planeAzimuth)};
}

}  // namespace

Curve sectionCurve(const Brdf& brdf, const Section& section, const TabulatedBrdf* coverage) {
  Curve curve{anglesOf(section), {}};
  std::vector<DirectionPair> pairs;
  pairs.reserve(curve.angles.size());
  for (const double angle : curve.angles) pairs.push_back(pairAt(section, angle));
  curve.points = evaluatePlotted(brdf, pairs, section.cosine, coverage);
  return curve;
}

double valueAt(const Curve& curve, double angle, Channel channel) {
  const auto next = std::lower_bound(curve.angles.begin(), curve.angles.end(), angle);
  if (next == curve.angles.end() || angle < curve.angles.front()) return std::numeric_limits<double>::quiet_NaN();
  const auto after = static_cast<std::size_t>(next - curve.angles.begin());
  if (*next == angle) return curve.points.at(after, channel);
  const double fraction = (angle - curve.angles[after - 1]) / (*next - curve.angles[after - 1]);
  return (1 - fraction) * curve.points.at(after - 1, channel) + fraction * curve.points.at(after, channel);
}

Curve polarLobe(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage) {
  return sectionCurve(brdf, {.axis = SectionAxis::thetaO, .thetaI = thetaI, .cosine = cosine}, coverage);
}

}  // namespace gonio::plots
