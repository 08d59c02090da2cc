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
  /// Reciprocal tables fold phi_d to [0, pi); others (360 phi_d samples in MERL files) cover the whole circle.
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
  /// Solid-angle weight of the cell at a node (unnormalised measure of d wi d wo over phi_h):
  /// sin thetaH dThetaH sin thetaD dThetaD dPhiD 4 cos thetaD, of the cell's own bounds (nodes are its midpoints).
  double cellMeasure(std::size_t index) const;

  /// Continuous grid position of coordinates: x = thetaHCount sqrt(thetaH / (pi/2)) and so on; phi folded or wrapped.
  /// Not clamped at the upper ends of theta.
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
  /// MERL's own look-up: the floor of each position, clamped.
  std::size_t nearestIndex(const HalfDifference& coordinates) const;
};

}  // namespace gonio
