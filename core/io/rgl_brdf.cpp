// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/rgl_brdf.h"

#include <algorithm>
#include <cmath>

namespace gonio::io {

namespace {

double thetaToUnit(double theta) { return std::sqrt(theta * (2 / pi)); }
double phiToUnit(double phi) {
  const double unit = (phi + pi) / (2 * pi);
  return unit - std::floor(unit);
}

/// Closer to the horizon (89.94 degrees) the stored product, which the instrument does not reach, is not divided
/// further: quotients stay bounded.
constexpr double minCosine = 1e-3;

/// One slice, whatever the incident direction.
constexpr SliceBlend onlySlice{1, {0}, {1}};

}  // namespace

RglBrdf::RglBrdf(RglData data) : data_(std::move(data)), visibleNormals_(std::move(data_.vndf), "vndf") {}

void RglBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
  for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = evaluateOne(pairs[i].wi, pairs[i].wo);
}

Rgb RglBrdf::evaluateOne(Direction wi, Direction wo) const {
  if (!(wi.z > horizonTolerance) || !(wo.z > horizonTolerance)) return Rgb(0);
  if (data_.azimuthReduction >= 2) {
    // Into the measured range of azimuths: half a turn, or a mirror image in one or both axes.
    const double flipY = std::signbit(wi.y) ? 1 : -1;
    const double flipX = data_.azimuthReduction == 4 ? (std::signbit(wi.x) ? 1 : -1) : flipY;
    for (Direction* direction : {&wi, &wo}) {
      direction->x *= flipX;
      direction->y *= flipY;
    }
  }
  const Direction half = wi + wo;
  const double thetaI = polarAngle(wi), phiI = azimuth(wi), phiM = azimuth(half);
  const glm::dvec2 incident(thetaToUnit(thetaI), phiToUnit(phiI));
  const glm::dvec2 normal(thetaToUnit(polarAngle(half)), phiToUnit(data_.isotropic ? phiM - phiI : phiM));

  const SliceBlend blend = data_.incident.blend(phiI, thetaI);
  Rgb value = interpolate<Rgb>(data_.rgb, blend, visibleNormals_.invert(blend, normal));
  if (data_.jacobian) {
    const double sigma = interpolate<double>(data_.sigma, onlySlice, incident);
    if (!(sigma > 0)) return Rgb(0);
    value *= interpolate<double>(data_.ndf, onlySlice, normal) / (4 * sigma);
  }
  return glm::max(value / std::max(wo.z, minCosine), Rgb(0));
}

}  // namespace gonio::io
