// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"

/// What plots show of a BRDF, as numbers: no drawing. Angles are rad; values linear RGB in 1/sr (conventions of
/// core/math/types.h), times the cosine that the caller chose.
namespace gonio::plots {

/// What a plotted value is multiplied with. Plots say which in the title of the axis.
enum class CosineFactor {
  none,      ///< f
  incident,  ///< f cos theta_i, the integrand of reflected light
  outgoing   ///< f cos theta_o, the light that a detector of fixed area collects from a lit spot
};

/// What is drawn of the three channels.
enum class Channel { luminance, red, green, blue };
double channelOf(Channel channel, const Rgb& value);

enum class PointState : std::uint8_t {
  known,
  belowHorizon,  ///< one of the directions is below the surface
  notMeasured    ///< the table has no valid cell about this point
};

struct PlottedValues {
  std::vector<Rgb> values;         ///< 0 where the state is not `known`
  std::vector<PointState> states;  ///< one a value

  /// The value of a channel, NaN where it is not known.
  double at(std::size_t index, Channel channel) const;
};

/// Evaluates pairs of directions. `coverage`, where given, is the measurement that decides which points are measured:
/// an edited measurement has no data where the measurement has none.
PlottedValues evaluatePlotted(const Brdf& brdf, std::span<const DirectionPair> pairs, CosineFactor cosine,
                              const TabulatedBrdf* coverage = nullptr);

/// Models are 0 at the horizon itself. Plots over angles end this much before it (rad, 0.05 degrees), so that no line
/// falls to 0 there.
inline constexpr double horizonMargin = radians(0.05);

}  // namespace gonio::plots
