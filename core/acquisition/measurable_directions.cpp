// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/measurable_directions.h"

#include <cmath>
#include <string>

#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::acquisition {

namespace {

constexpr double tolerance = 1e-9;  // rad

void checkAngle(double angle, double largest, const std::string& what) {
  if (angle >= 0 && angle <= largest + tolerance) return;
  throw Error(what + " is " + numberText(degrees(angle)) + " degrees: expected 0 to " + numberText(degrees(largest)));
}

void checkRange(const AngleRange& range, double largest, const std::string& what) {
  checkAngle(range.lowest, largest, "the minimum " + what);
  checkAngle(range.highest, largest, "the maximum " + what);
  if (range.lowest > range.highest)
    throw Error("the minimum " + what + ", " + numberText(degrees(range.lowest)) + " degrees, is above the maximum, " +
                numberText(degrees(range.highest)));
}

bool contains(const AngleRange& range, double angle) {
  return angle >= range.lowest - tolerance && angle <= range.highest + tolerance;
}

/// The polar angles and |phi_i - phi_o| of a pair.
struct RigAngles {
  double thetaI, thetaO, azimuthDifference;
  bool anyAzimuth;  ///< one direction is the normal
};

RigAngles rigAngles(const DirectionPair& pair) {
  const auto& [wi, wo] = pair;
  RigAngles result{polarAngle(wi), polarAngle(wo), 0, false};
  const double along = wi.x * wo.x + wi.y * wo.y, across = wi.x * wo.y - wi.y * wo.x;
  result.azimuthDifference = std::atan2(std::abs(across), along);
  result.anyAzimuth = result.thetaI <= tolerance || result.thetaO <= tolerance;
  return result;
}

bool isIn(const ForbiddenRegion& box, const RigAngles& at) {
  if (!contains(box.thetaI, at.thetaI) || !contains(box.thetaO, at.thetaO)) return false;
  const AngleRange& azimuths = box.azimuthDifference;
  return at.anyAzimuth ? contains(azimuths, 0) && contains(azimuths, pi) : contains(azimuths, at.azimuthDifference);
}

}  // namespace

void MeasurableDirections::check() const {
  checkAngle(maxPolarAngle, halfPi, "the maximum polar angle");
  checkAngle(minSeparation, pi, "the minimum separation of light and viewer");
  for (std::size_t i = 0; i < forbidden.size(); ++i) {
    const std::string of = " of forbidden region " + std::to_string(i + 1);
    checkRange(forbidden[i].thetaI, halfPi, "polar angle of the light" + of);
    checkRange(forbidden[i].thetaO, halfPi, "polar angle of the viewer" + of);
    checkRange(forbidden[i].azimuthDifference, pi, "azimuth difference" + of);
  }
}

bool MeasurableDirections::allows(const DirectionPair& pair) const {
  const auto& [wi, wo] = pair;
  if (isBelowHorizon(wi) || isBelowHorizon(wo)) return false;
  const RigAngles at = rigAngles(pair);
  if (!(at.thetaI <= maxPolarAngle + tolerance && at.thetaO <= maxPolarAngle + tolerance)) return false;
  const double separation = std::atan2(glm::length(glm::cross(wi, wo)), glm::dot(wi, wo));
  if (separation < minSeparation - tolerance) return false;
  for (const ForbiddenRegion& box : forbidden)
    if (isIn(box, at)) return false;
  return true;
}

}  // namespace gonio::acquisition
