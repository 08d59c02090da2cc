// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <span>

#include "core/math/types.h"

namespace gonio {

/// Squared length of wi + wo at or below which a pair has no half vector: the directions are opposite up to rounding.
inline constexpr double minSquaredHalfLength = 1e-24;

/// Half-difference coordinates of Rusinkiewicz, "A New Change of Variables for Efficient BRDF Representation" (1998).
/// phi_h is omitted: isotropic materials do not depend on it.
struct HalfDifference {
  double thetaH = 0;  ///< angle between the half vector and the normal, rad, [0, pi/2] above the horizon
  double thetaD = 0;  ///< half the angle between wi and wo, rad, [0, pi/2]
  double phiD = 0;    ///< azimuth of wi about the half vector, rad, (-pi, pi]
  bool valid = true;  ///< false when wi = -wo: no half vector exists
};

/// Computed from vectors without inverse cosines, so accurate to rounding everywhere: for a half vector at the normal
/// (phi_d is relative to the x axis), at retro-reflection (phi_d = 0) and at grazing angles. Exchanging wi and wo adds
/// pi to phi_d. O(1); for many pairs HalfDifferenceBlock is faster.
HalfDifference toHalfDifference(const Direction& wi, const Direction& wo);

/// phi_d folded to [0, pi) by reciprocity, as MERL does.
inline double foldPhiD(double phiD) {
  phiD = phiD < 0 ? phiD + pi : phiD;
  phiD = phiD >= pi ? phiD - pi : phiD;
  return phiD < 0 ? 0 : phiD;
}

/// Inverse, with phi_h = 0. Either direction can be below the horizon: see isAboveHorizon(). O(1).
DirectionPair fromHalfDifference(double thetaH, double thetaD, double phiD);

/// Whether both directions of these coordinates have z >= 0:
/// cos thetaH cos thetaD >= sin thetaH sin thetaD |cos phiD|.
bool isAboveHorizon(double thetaH, double thetaD, double phiD);

/// fromHalfDifference() and isAboveHorizon() for given sines and cosines of the angles.
inline DirectionPair fromHalfDifference(double sinH, double cosH, double sinD, double cosD, double sinPhi,
                                        double cosPhi) {
  const double dx = sinD * cosPhi, dy = sinD * sinPhi;
  const Direction alongHalf{sinH * cosD, 0, cosH * cosD};
  const Direction across{cosH * dx, dy, -sinH * dx};
  return {alongHalf + across, alongHalf - across};
}
inline bool isAboveHorizon(double sinH, double cosH, double sinD, double cosD, double cosPhi) {
  const double along = cosD * cosH, across = sinD * cosPhi * sinH;
  return along - across >= 0 && along + across >= 0;
}

/// Half-difference coordinates of a block of pairs as separate arrays, for vectorised loops over tables.
struct HalfDifferenceBlock {
  static constexpr std::size_t capacity = 64;
  double thetaH[capacity];
  double thetaD[capacity];
  double phiD[capacity];
  std::int64_t valid[capacity];  ///< 1, or 0 where wi = -wo
};

/// Fills the first pairs.size() (<= capacity) entries. Bitwise equal to toHalfDifference() of one pair; about 15 ns per
/// pair.
void toHalfDifference(std::span<const DirectionPair> pairs, HalfDifferenceBlock& block);

}  // namespace gonio
