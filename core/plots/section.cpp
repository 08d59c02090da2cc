// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/section.h"

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

Curve polarLobe(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage) {
  return sectionCurve(brdf, {.axis = SectionAxis::thetaO, .thetaI = thetaI, .cosine = cosine}, coverage);
}

}  // namespace gonio::plots
