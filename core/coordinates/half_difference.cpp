// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/half_difference.h"

#include <cmath>

namespace gonio {

namespace {
constexpr double minSquaredHalfLength = 1e-24;
constexpr double minPoleRadius = 1e-12;
constexpr double minDifferenceLength = 1e-12;
}  // namespace

HalfDifference toHalfDifference(const Direction& wi, const Direction& wo) {
  const Direction sum = wi + wo;
  const Direction difference = wi - wo;
  const double squaredLength = glm::dot(sum, sum);
  if (squaredLength < minSquaredHalfLength) return {0, 0, 0, false};
  const double sumLength = std::sqrt(squaredLength);
  const Direction h = sum / sumLength;
  const double differenceLength = glm::length(difference);

  HalfDifference result;
  const double r = std::hypot(h.x, h.y);
  result.thetaH = std::atan2(r, h.z);
  result.thetaD = std::atan2(differenceLength, sumLength);
  if (differenceLength < minDifferenceLength) return result;

  Direction tangent{1, 0, 0}, bitangent{0, 1, 0};
  if (r > minPoleRadius) {
    tangent = {h.z * h.x / r, h.z * h.y / r, -r};
    bitangent = {-h.y / r, h.x / r, 0};
  }
  // The difference vector has the direction of wi's part across h, without wi's part along h: no cancellation.
  result.phiD = std::atan2(glm::dot(difference, bitangent), glm::dot(difference, tangent));
  return result;
}

double foldPhiD(double phiD) {
  if (phiD < 0) phiD += pi;
  if (phiD >= pi) phiD -= pi;
  return phiD < 0 ? 0 : phiD;
}

DirectionPair fromHalfDifference(double thetaH, double thetaD, double phiD) {
  const double sh = std::sin(thetaH), ch = std::cos(thetaH);
  const double sd = std::sin(thetaD), cd = std::cos(thetaD);
  const double dx = sd * std::cos(phiD), dy = sd * std::sin(phiD);
  const Direction alongHalf{sh * cd, 0, ch * cd};
  const Direction across{ch * dx, dy, -sh * dx};
  return {alongHalf + across, alongHalf - across};
}

bool isAboveHorizon(double thetaH, double thetaD, double phiD) {
  const double along = std::cos(thetaD) * std::cos(thetaH);
  const double across = std::sin(thetaD) * std::cos(phiD) * std::sin(thetaH);
  return along - across >= 0 && along + across >= 0;
}

}  // namespace gonio
