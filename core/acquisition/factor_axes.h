// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/math/types.h"

/// The two coordinates of a factor measurement: an angle, and the distance of the light from the mirror direction of
/// the viewer. One curve ("along") is measured in the mirror direction over the angle, the other ("across") at a fixed
/// angle over the distance. theta_R is the polar angle of the mirror direction, equal to that of the viewer; |Dp| is
/// defined in core/coordinates/projected_deviation.h.
namespace gonio::acquisition {

enum class FactorAxes {
  projectedDeviation,  ///< theta_R, |Dp| (Tongbuasirilai et al. 2017)
  /// theta_d, |Dp|, which do not change when light and viewer are exchanged. Not in the paper. The readings are those
  /// of projectedDeviation: in the mirror direction theta_d is theta_R.
  symmetricDeviation,
  halfDifference,  ///< theta_d, theta_h
  halfOut          ///< theta_o, theta_h
};
/// Names in JSON, in files and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> factorAxesNames{"projected-deviation", "symmetric-deviation",
                                                                 "half-difference", "half-out"};
/// @throws Error that lists the names.
FactorAxes factorAxesNamed(std::string_view name);

struct FactorCoordinates {
  double angle = 0;     ///< theta_R, theta_d or theta_o, rad, [0, pi/2]
  double distance = 0;  ///< |Dp|, [0, 2), or theta_h, rad, [0, pi/2]; 0 in the mirror direction
};
/// The coordinates of any two directions above the horizon. O(1).
FactorCoordinates toFactorCoordinates(FactorAxes axes, const DirectionPair& pair);

/// Whether the coordinates do not change when light and viewer are exchanged.
inline bool areReciprocal(FactorAxes axes) {
  return axes == FactorAxes::symmetricDeviation || axes == FactorAxes::halfDifference;
}
/// Whether the distance is |Dp|, otherwise theta_h.
inline bool isDeviation(FactorAxes axes) {
  return axes == FactorAxes::projectedDeviation || axes == FactorAxes::symmetricDeviation;
}

/// The pair of directions in the plane of incidence with these coordinates; the light is between the mirror direction
/// and the viewer, or beyond the viewer. For symmetricDeviation the angle is theta_R here, not theta_d, because its
/// readings are those of projectedDeviation. None if no light above the horizon exists. O(1).
std::optional<DirectionPair> fromFactorCoordinates(FactorAxes axes, const FactorCoordinates& place);

}  // namespace gonio::acquisition
