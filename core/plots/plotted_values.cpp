// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/plotted_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/coordinates/coordinate_systems.h"
#include "core/coordinates/half_difference.h"
#include "core/math/parallel.h"
#include "core/sampling/directional_albedo.h"

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

std::vector<double> nodesAbout(double centre, double first, double last, int count, double density) {
  centre = std::clamp(centre, first, last);
  // x = centre + scale sinh(t), t even from `from` to `to`: dx/dt grows from scale to scale cosh(t).
  const double farthest = std::max(last - centre, centre - first);
  const double scale = farthest / std::sqrt(density * density - 1);
  const double from = std::asinh((first - centre) / scale), to = std::asinh((last - centre) / scale);
  std::vector<double> nodes(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    nodes[std::size_t(i)] = centre + scale * std::sinh(from + (to - from) * i / double(count - 1));
  nodes.front() = first;
  nodes.back() = last;
  return nodes;
}

namespace {

constexpr double end = halfPi - horizonMargin;

std::vector<double> anglesOf(const Section& section) {
  switch (section.axis) {
    case SectionAxis::thetaH:
      return nodesAbout(0, 0, end, section.count);
    case SectionAxis::thetaD:
      return nodesAbout(halfPi, 0, end, section.count, 8);
    case SectionAxis::thetaO:
      break;
  }
  return nodesAbout(section.thetaI, -end, end, section.count);
}

DirectionPair pairAt(const Section& section, double angle) {
  switch (section.axis) {
    case SectionAxis::thetaH:
      return fromHalfDifference(angle, section.thetaD, section.phiD);
    case SectionAxis::thetaD:
      return fromHalfDifference(section.thetaH, angle, section.phiD);
    case SectionAxis::thetaO:
      break;
  }
  return {fromSpherical(section.thetaI, pi), fromSpherical(angle, section.planeAzimuth)};
}

}  // namespace

Curve sectionCurve(const Brdf& brdf, const Section& section, const TabulatedBrdf* coverage) {
  Curve curve{anglesOf(section), {}};
  std::vector<DirectionPair> pairs;
  pairs.reserve(curve.angles.size());
  for (const double angle : curve.angles) pairs.push_back(pairAt(section, angle));
  curve.points = evaluatePlotted(brdf, pairs, section.cosine, coverage);
  return curve;
}

double valueAt(const Curve& curve, double angle, Channel channel) {
  const auto next = std::lower_bound(curve.angles.begin(), curve.angles.end(), angle);
  if (next == curve.angles.end() || angle < curve.angles.front()) return std::numeric_limits<double>::quiet_NaN();
  const auto after = static_cast<std::size_t>(next - curve.angles.begin());
  if (*next == angle) return curve.points.at(after, channel);
  const double fraction = (angle - curve.angles[after - 1]) / (*next - curve.angles[after - 1]);
  return (1 - fraction) * curve.points.at(after - 1, channel) + fraction * curve.points.at(after, channel);
}

Curve polarLobe(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage) {
  return sectionCurve(brdf, {.axis = SectionAxis::thetaO, .thetaI = thetaI, .cosine = cosine}, coverage);
}

double thetaHFraction(ThetaHSpacing spacing, double thetaH) {
  const double fraction = thetaH / halfPi;
  return spacing == ThetaHSpacing::linear ? fraction : std::sqrt(std::max(0.0, fraction));
}

double thetaHAt(ThetaHSpacing spacing, double fraction) {
  return halfPi * (spacing == ThetaHSpacing::linear ? fraction : fraction * fraction);
}

const SliceAxes& axesOf(SliceCoordinates coordinates) {
  static constexpr std::array<SliceAxes, 3> table{
      {{"half-difference", 0, 1, 2, "θh", "θd", "φd", "Azimuth of the light about the half vector"},
       {"half-out", 1, 0, 2, "θh", "θo", "φh", "Azimuth of the half vector from the viewer"},
       {"projected-deviation", 1, 0, 2, "|Δp|", "θR", "φ",
        "Azimuth of the projected deviation vector: 0 points from the mirror direction toward the viewer", 2}}};
  return table[std::size_t(coordinates)];
}

double Slice::across(int column) const {
  return axesOf(coordinates).acrossEnd / halfPi * thetaHAt(spacing, (column + 0.5) / width);
}
double Slice::up(int row) const { return halfPi * (row + 0.5) / height; }

Slice sliceOf(const Brdf& brdf, SliceCoordinates coordinates, double azimuth, ThetaHSpacing spacing,
              CosineFactor cosine, const TabulatedBrdf* coverage, int size) {
  Slice slice{size, size, coordinates, spacing, azimuth, {}};
  const SliceAxes& axes = axesOf(coordinates);
  const CoordinateSystem& system = coordinateSystemNamed(axes.system);
  constexpr DirectionPair below{{0, 0, -1}, {0, 0, -1}};
  std::vector<DirectionPair> pairs;
  pairs.reserve(std::size_t(size) * std::size_t(size));
  std::array<double, 3> values{};
  values[axes.azimuth] = azimuth;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      values[axes.across] = slice.across(column);
      values[axes.up] = slice.up(row);
      pairs.push_back(system.from(values).value_or(below));
    }
  slice.cells = evaluatePlotted(brdf, pairs, cosine, coverage);
  return slice;
}

Curve albedoCurve(const Brdf& brdf, int count, int samples, const TaskControl& control) {
  constexpr double last = radians(89);
  const auto size = static_cast<std::size_t>(count);
  Curve curve{std::vector<double>(size), {std::vector<Rgb>(size), std::vector<PointState>(size, PointState::known)}};
  for (std::size_t i = 0; i < size; ++i)
    curve.angles[i] = last * (1 - std::pow(1 - double(i) / double(count - 1), 1.5));
  const DirectionalAlbedo albedo(brdf, std::uint32_t(samples));
  parallelForBlocks(
      size, 1,
      [&](std::size_t begin, std::size_t finish) {
        for (std::size_t i = begin; i < finish; ++i) curve.points.values[i] = albedo(curve.angles[i]);
      },
      control);
  return curve;
}

LobeSurface lobeSurface(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage, int rings,
                        int sectors) {
  LobeSurface lobe{rings, sectors, {}, {}};
  const std::vector<double> polar = nodesAbout(thetaI, 0, halfPi - horizonMargin, rings);
  // One node more than sectors: pi and -pi are the same.
  const std::vector<double> azimuths = nodesAbout(0, -pi, pi, sectors + 1);
  const Direction wi = fromSpherical(thetaI, pi);
  std::vector<DirectionPair> pairs;
  for (const double theta : polar)
    for (int sector = 0; sector < sectors; ++sector)
      pairs.push_back({wi, fromSpherical(theta, azimuths[std::size_t(sector)])});
  for (const DirectionPair& pair : pairs) lobe.directions.push_back(pair.wo);
  lobe.points = evaluatePlotted(brdf, pairs, cosine, coverage);
  return lobe;
}

}  // namespace gonio::plots
