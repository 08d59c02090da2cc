// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/plotted_values.h"

#include <limits>

#include "core/coordinates/half_difference.h"

namespace gonio::plots {

namespace {

PointState stateOf(const DirectionPair& pair, const TabulatedBrdf* coverage) {
  if (isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) return PointState::belowHorizon;
  if (!coverage) return PointState::known;
  const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
  bool valid = at.valid;
  if (valid) coverage->lookup(at, TableLookup::trilinear, &valid);
  return valid ? PointState::known : PointState::notMeasured;
}

double cosineOf(CosineFactor cosine, const DirectionPair& pair) {
  if (cosine == CosineFactor::none) return 1;
  const double z = cosine == CosineFactor::incident ? pair.wi.z : pair.wo.z;
  return z > 0 ? z : 0;
}

}  // namespace

double channelOf(Channel channel, const Rgb& value) {
  switch (channel) {
    case Channel::red:
      return value.x;
    case Channel::green:
      return value.y;
    case Channel::blue:
      return value.z;
    case Channel::luminance:
      break;
  }
  return luminance(value);
}

double PlottedValues::at(std::size_t index, Channel channel) const {
  if (states[index] != PointState::known) return std::numeric_limits<double>::quiet_NaN();
  return channelOf(channel, values[index]);
}

PlottedValues evaluatePlotted(const Brdf& brdf, std::span<const DirectionPair> pairs, CosineFactor cosine,
                              const TabulatedBrdf* coverage) {
  PlottedValues plotted{std::vector<Rgb>(pairs.size()), std::vector<PointState>(pairs.size())};
  brdf.evaluate(pairs, plotted.values);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    plotted.states[i] = stateOf(pairs[i], coverage);
    plotted.values[i] *= plotted.states[i] == PointState::known ? cosineOf(cosine, pairs[i]) : 0.0;
  }
  return plotted;
}

}  // namespace gonio::plots
