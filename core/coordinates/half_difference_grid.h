// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
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

  /// The same nodes over the whole circle of phi_d: the second half has light and viewer exchanged.
  HalfDifferenceGrid wholeCircle() const {
    return {thetaHCount, thetaDCount, reciprocal ? 2 * phiDCount : phiDCount, false};
  }

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

/// The two neighbouring nodes of a position on one axis, and the weight of the upper one.
struct GridBracket {
  int low, high;
  double weight;
};

/// Beyond the last node, values of the last node. @param position in nodes.
inline GridBracket clampedBracket(double position, int count) {
  position = std::clamp(position, 0.0, count - 1.0);
  const int low = static_cast<int>(position);
  return {low, std::min(low + 1, count - 1), position - low};
}

/// After the last node, the first. @param position in nodes, in [0, count].
inline GridBracket wrappedBracket(double position, int count) {
  const int low = std::min(static_cast<int>(position), count - 1);
  return {low, low + 1 == count ? 0 : low + 1, position - low};
}

/// The eight nodes about a position in a grid, for trilinear interpolation: a corner has the upper node of phi_d if its
/// bit 0 is set, of theta_d if bit 1 is, of theta_h if bit 2 is.
struct GridCorners {
  GridBracket thetaH, thetaD, phiD;
  std::size_t rows[4];  ///< first cells of the phi_d rows, by bits 1 and 2 of the corner

  GridCorners() = default;  ///< uninitialised
  GridCorners(const HalfDifferenceGrid& grid, const HalfDifferenceGrid::Position& position)
      : thetaH(clampedBracket(position.thetaH, grid.thetaHCount)),
        thetaD(clampedBracket(position.thetaD, grid.thetaDCount)),
        phiD(wrappedBracket(position.phiD, grid.phiDCount)),
        rows{grid.index(thetaH.low, thetaD.low, 0), grid.index(thetaH.low, thetaD.high, 0),
             grid.index(thetaH.high, thetaD.low, 0), grid.index(thetaH.high, thetaD.high, 0)} {}

  std::size_t cell(int corner) const {
    return rows[corner >> 1] + static_cast<std::size_t>((corner & 1) != 0 ? phiD.high : phiD.low);
  }
  /// The weights of all corners sum to 1.
  double weight(int corner) const {
    return ((corner & 4) != 0 ? thetaH.weight : 1 - thetaH.weight) *
           ((corner & 2) != 0 ? thetaD.weight : 1 - thetaD.weight) *
           ((corner & 1) != 0 ? phiD.weight : 1 - phiD.weight);
  }
};

}  // namespace gonio
