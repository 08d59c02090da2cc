// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"

/// Data of plots of a BRDF, without drawing. Angles are in rad; values are linear RGB, 1/sr (conventions of
/// core/math/types.h), times the chosen CosineFactor.
namespace gonio::plots {

/// The factor of plotted values, which plots state in the title of the axis.
enum class CosineFactor {
  none,      ///< f
  incident,  ///< f cos theta_i, the integrand of reflected light
  outgoing   ///< f cos theta_o, proportional to the power that a distant detector of fixed area receives from an
             ///< illuminated spot
};

/// The plotted channel.
enum class Channel { luminance, red, green, blue };
double channelOf(Channel channel, const Rgb& value);

enum class PointState : std::uint8_t {
  known,
  belowHorizon,  ///< a direction is below the surface
  notMeasured    ///< the table has no valid cell around this point
};

struct PlottedValues {
  std::vector<Rgb> values;         ///< 0 if the state is not `known`
  std::vector<PointState> states;  ///< one per value

  /// The value of a channel; NaN if it is not known.
  double at(std::size_t index, Channel channel) const;
};

/// Evaluates pairs of directions. @param coverage if not null, the measurement that determines which points are
/// measured, such as the base of an edited measurement.
PlottedValues evaluatePlotted(const Brdf& brdf, std::span<const DirectionPair> pairs, CosineFactor cosine,
                              const TabulatedBrdf* coverage = nullptr);

/// Distance from the horizon at which plots over angles end, rad (0.05 degrees): models are 0 on the horizon, and lines
/// would drop to 0 there.
inline constexpr double horizonMargin = radians(0.05);

}  // namespace gonio::plots
