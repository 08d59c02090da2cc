// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <cstddef>

#include "core/coordinates/half_difference.h"

namespace gonio {

/// The sampling grid of MERL-like tables: theta_h warped by a square root (dense at the highlight), theta_d and phi_d
/// uniform. The value stored at index (i, j, k) belongs to the node
///   theta_h = (i / thetaHCount)^2 pi/2,  theta_d = (j / thetaDCount) pi/2,  phi_d = (k / phiDCount) phiDPeriod().
/// phi_d wraps. Matusik et al., "A Data-Driven Reflectance Model" (2003).
struct HalfDifferenceGrid {
  int thetaHCount = 90;
  int thetaDCount = 90;
  int phiDCount = 180;
  /// Whether phi_d is folded to [0, pi), as in MERL files, which only represents reciprocal materials; otherwise it
  /// covers the whole circle (usually phiDCount = 360; Gonio writes such tables in the MERL layout, too).
  bool reciprocal = true;

  bool operator==(const HalfDifferenceGrid&) const = default;

  double phiDPeriod() const { return reciprocal ? pi : 2 * pi; }
  std::size_t size() const { return std::size_t(thetaHCount) * std::size_t(thetaDCount) * std::size_t(phiDCount); }
  /// phi_d runs fastest, theta_h slowest, as in MERL files.
  std::size_t index(int i, int j, int k) const {
    return (std::size_t(i) * std::size_t(thetaDCount) + std::size_t(j)) * std::size_t(phiDCount) + std::size_t(k);
  }

  /// Coordinates of a node, rad.
  HalfDifference node(std::size_t index) const;
  /// Directions of a node (phi_h = 0).
  DirectionPair directions(std::size_t index) const;
  /// Whether both directions of the node are at or above the horizon.
  bool nodeAboveHorizon(std::size_t index) const;
  /// Whether both polar angles of the node are at most `maxPolarAngle` (rad).
  bool nodeWithin(std::size_t index, double maxPolarAngle) const;
  /// Solid-angle weight d wi d wo of the cell at a node, sr^2 per radian of phi_h, without cosines: the integral of 4
  /// cos thetaD sin thetaH sin thetaD dThetaH dThetaD dPhiD over the cell, which extends half a step to each side of
  /// the node.
  double cellMeasure(std::size_t index) const;

  /// Continuous grid position of coordinates: thetaHCount sqrt(thetaH / (pi/2)) and so on; phi_d is folded or wrapped.
  /// theta_h and theta_d are not clamped to the last node.
  struct Position {
    double thetaH, thetaD, phiD;
  };
  Position position(const HalfDifference& coordinates) const {
    return position(coordinates.thetaH, coordinates.thetaD, coordinates.phiD);
  }
  Position position(double thetaH, double thetaD, double phiD) const {
    const double phi = reciprocal ? foldPhiD(phiD) : (phiD < 0 ? phiD + 2 * pi : phiD);
    return {std::sqrt((thetaH > 0 ? thetaH : 0.0) / halfPi) * thetaHCount, thetaD / halfPi * thetaDCount,
            phi * (phiDCount / phiDPeriod())};
  }
  /// Index of the cell that contains the coordinates, as in the MERL reference code: the floor of each position,
  /// clamped. Not the nearest node; unlike in cellMeasure(), these cells start at their nodes.
  std::size_t cellIndex(const HalfDifference& coordinates) const;
};

}  // namespace gonio
