// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/math/range.h"
#include "core/math/types.h"

namespace gonio {

/// A set of direction pairs: all whose viewer wo and half vector h have spherical angles in these ranges and whose
/// light wi = 2 (wo . h) h - wo is above the horizon. Half vectors, because highlights stay in place there for all
/// viewers. All members but `measure` contain the quantity for every pair of the set.
struct PairBox {
  Range thetaO, phiO;  ///< polar angle and azimuth of wo
  Range thetaH, psi;   ///< polar angle of h, in [0, pi/2], and its azimuth from that of wo, in [-pi, pi]
  Range cosO, sinO, cosI, cosD, cosH, sinH, cosPsi;
  Range rise;          ///< wi.z - wo.z, without cancellation
  double measure = 0;  ///< upper bound of the integral of cos theta_i over the lights of any one viewer of the set

  /// Not negative angles, except psi. @param phiO {0, 0} for isotropic BRDFs.
  PairBox(const Range& thetaO, const Range& thetaH, const Range& psi, const Range& phiO = 0);

  /// Whether no light of the set is above the horizon.
  bool isEmpty() const { return !(cosI.high > 0) || !(cosD.high > 0); }
  Range thetaD() const;
  Range thetaI() const;
  /// Azimuth of wi from that of wo, in [-pi, pi].
  Range phiI() const;
};

struct RgbRange {
  Rgb low{0}, high{0};
};

/// The nodes between which a range of positions is interpolated, clamped to the ends.
struct NodeSpan {
  int first, last;

  /// @param position in nodes; may be infinite.
  NodeSpan(const Range& position, int count) {
    constexpr double rounding = 1e-6;
    const double end = count - 1;
    first = int(std::floor(std::clamp(position.low - rounding, 0.0, end)));
    last = int(std::ceil(std::clamp(position.high + rounding, 0.0, end)));
  }
};

/// The extrema of values over the cells of a two-dimensional grid.
class GridExtrema {
 public:
  GridExtrema(int rows, int columns)
      : columns_(columns), cells_(std::size_t(rows) * std::size_t(columns), {Rgb(infinity), Rgb(-infinity)}) {}

  void include(int row, int column, const Rgb& value) {
    RgbRange& cell = cells_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)];
    cell.low = glm::min(cell.low, value);
    cell.high = glm::max(cell.high, value);
  }
  /// Both 0 where there is no value.
  RgbRange over(const NodeSpan& rows, const NodeSpan& columns) const {
    RgbRange result{Rgb(infinity), Rgb(-infinity)};
    for (int row = rows.first; row <= rows.last; ++row)
      for (int column = columns.first; column <= columns.last; ++column) {
        const RgbRange& cell = cells_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)];
        result.low = glm::min(result.low, cell.low);
        result.high = glm::max(result.high, cell.high);
      }
    return result.low.x <= result.high.x ? result : RgbRange{};
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  int columns_;
  std::vector<RgbRange> cells_;
};

/// The bounds of a BRDF's values over sets of pairs. Immutable.
class ValueBound {
 public:
  virtual ~ValueBound() = default;

  /// Contains the value of every pair of the set that is above the horizon, in each channel, 1/sr, up to rounding. For
  /// isotropic BRDFs that are symmetric about the plane of the viewer as measured or not, it also holds for the
  /// mirrored set (-psi). The bounds may be infinite.
  virtual RgbRange over(const PairBox& box) const = 0;

  /// Whether the bound of a small set is near the values there. If not, it also rests on values of other directions, so
  /// that a large bound does not indicate a peak.
  virtual bool isLocal() const { return true; }
};

}  // namespace gonio
