// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/incidence_table_brdf.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/brdf/value_bound.h"
#include "core/math/types.h"
#include "core/support/error.h"

namespace gonio {

namespace {

/// Rounding of angles in degrees that became radians, and of directions.
constexpr double incidenceTolerance = 1e-9;

using Axis = IncidenceTable::Axis;

using Angle = SineAndCosine;

Angle angleOf(double radians) { return {std::sin(radians), std::cos(radians)}; }

/// Angles about an axis. Sines and cosines come from the components of directions, which is faster than from the
/// angles.
struct Place {
  Angle polar, azimuth;

  double polarAngle() const { return fastAtan2(polar.sine, polar.cosine); }
  double azimuthAngle() const { return fastAtan2(azimuth.sine, azimuth.cosine); }
};

/// The axis of a table for a light at azimuth 0; azimuth 0 about it is in the plane of incidence.
struct Frame {
  Angle axis{0, 1};  ///< polar angle; the axis is opposite to the light

  Frame(Axis kind, const Angle& light) {
    if (kind == Axis::mirror) axis = light;
  }
  Direction direction(const Place& at) const {
    const double along = at.polar.cosine, zero = at.polar.sine * at.azimuth.cosine;
    return {axis.cosine * zero - axis.sine * along, at.polar.sine * at.azimuth.sine,
            axis.sine * zero + axis.cosine * along};
  }
  Place place(const Direction& w) const {
    const double zero = axis.cosine * w.x + axis.sine * w.z, along = axis.cosine * w.z - axis.sine * w.x;
    const double across = std::sqrt(zero * zero + w.y * w.y);
    return {{across, along}, across > 0 ? Angle{w.y / across, zero / across} : Angle{0, 1}};
  }
};

/// The angle from the mirror direction at which the horizon is, at an azimuth about it; lower ones are above it.
Angle horizonOf(const Angle& light, const Angle& azimuth) {
  const double along = -light.sine * azimuth.cosine, size = std::sqrt(along * along + light.cosine * light.cosine);
  return size > 0 ? Angle{light.cosine / size, along / size} : Angle{0, 1};
}

/// A place between two nodes.
struct IncidenceBracket {
  std::size_t below, above;
  double fraction;  ///< of `above`
};

/// Held at the ends.
IncidenceBracket bracketOf(const std::vector<double>& nodes, double at) {
  const auto next = std::size_t(std::upper_bound(nodes.begin(), nodes.end(), at) - nodes.begin());
  if (next == 0) return {0, 0, 0};
  if (next == nodes.size()) return {next - 1, next - 1, 0};
  return {next - 1, next, (at - nodes[next - 1]) / (nodes[next] - nodes[next - 1])};
}

/// The bracket of an azimuth in (-pi, pi]: the last node is followed by the first one plus 2 pi.
IncidenceBracket circleBracket(const std::vector<double>& nodes, double azimuth) {
  if (nodes.size() == 1) return {0, 0, 0};
  const double at = azimuth < 0 ? azimuth + 2 * pi : azimuth;
  if (at >= nodes.front() && at <= nodes.back()) return bracketOf(nodes, at);
  const double gap = nodes.front() + 2 * pi - nodes.back();
  const double past = (at < nodes.front() ? at + 2 * pi : at) - nodes.back();
  return {nodes.size() - 1, 0, gap > 0 ? past / gap : 0};
}

void checkNodes(const std::vector<double>& nodes, double highest, const char* name) {
  if (nodes.empty()) throw Error(std::string("found no ") + name + ", expected at least one");
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!(nodes[i] >= -incidenceTolerance && nodes[i] <= highest + incidenceTolerance) ||
        (i > 0 && !(nodes[i] > nodes[i - 1])))
      throw Error("found the " + std::string(name) + " " + std::to_string(degrees(nodes[i])) +
                  " degrees, expected ascending angles from 0 to " + std::to_string(std::lround(degrees(highest))) +
                  " degrees");
}

void checkIncidences(const IncidenceTable& table) {
  checkNodes(table.incident, halfPi, "angle of incidence");
  checkNodes(table.azimuths, table.symmetric ? pi : 2 * pi, "azimuth");
  checkNodes(table.polars, pi, "polar angle");
  checkNodes(table.rotations, 2 * pi, "azimuth of the light");
  const std::size_t expected =
      table.rotations.size() * table.incident.size() * table.azimuths.size() * table.polars.size();
  if (table.values.size() != expected)
    throw Error("found " + std::to_string(table.values.size()) + " values, expected " + std::to_string(expected));
  for (std::size_t i = 0; i < expected; ++i)
    if (!std::isfinite(table.values[i].x + table.values[i].y + table.values[i].z))
      throw Error("value " + std::to_string(i) + " is not a finite number");
}

std::size_t cutNegative(std::vector<glm::vec3>& values) {
  std::size_t count = 0;
  for (glm::vec3& value : values)
    for (int channel = 0; channel < 3; ++channel) {
      count += value[channel] < 0;
      value[channel] = std::max(value[channel], 0.0f);
    }
  return count;
}

/// One direction has one value.
void uniteAxis(IncidenceTable& table) {
  if (table.polars.front() > 0) return;
  const std::size_t azimuths = table.azimuths.size(), polars = table.polars.size();
  for (std::size_t i = 0; i < table.rotations.size() * table.incident.size(); ++i) {
    glm::dvec3 mean(0);
    for (std::size_t a = 0; a < azimuths; ++a) mean += glm::dvec3(table.values[(i * azimuths + a) * polars]);
    for (std::size_t a = 0; a < azimuths; ++a) table.values[(i * azimuths + a) * polars] = mean / double(azimuths);
  }
}

std::vector<std::uint8_t> nodesAboveHorizon(const IncidenceTable& table) {
  std::vector<std::uint8_t> result;
  result.reserve(table.values.size());
  for (std::size_t light = 0; light < table.rotations.size() * table.incident.size(); ++light) {
    const Frame frame(table.axis, angleOf(table.incident[light % table.incident.size()]));
    for (const double azimuth : table.azimuths)
      for (const double polar : table.polars)
        result.push_back(frame.direction({angleOf(polar), angleOf(azimuth)}).z >= -incidenceTolerance);
  }
  return result;
}

}  // namespace

/// A sum of values by the sum of their weights.
struct IncidenceTableBrdf::Weighted {
  Rgb sum{0};
  double weight = 0;
};

IncidenceTableBrdf::IncidenceTableBrdf(IncidenceTable table) : table_(std::move(table)) {
  checkIncidences(table_);
  clampedCount_ = cutNegative(table_.values);
  uniteAxis(table_);
  aboveHorizon_ = nodesAboveHorizon(table_);
  for (const double incident : table_.incident) incident_.push_back(angleOf(incident));
}

IncidenceTableBrdf::Weighted IncidenceTableBrdf::lookup(std::size_t light, double polar, double azimuth) const {
  const IncidenceBracket p = bracketOf(table_.polars, polar), a = table_.symmetric
                                                                      ? bracketOf(table_.azimuths, std::abs(azimuth))
                                                                      : circleBracket(table_.azimuths, azimuth);
  Weighted result;
  for (const auto& [node, weightA] : {std::pair(a.below, 1 - a.fraction), {a.above, a.fraction}})
    for (const auto& [step, weightP] : {std::pair(p.below, 1 - p.fraction), {p.above, p.fraction}}) {
      const std::size_t index = (light * table_.azimuths.size() + node) * table_.polars.size() + step;
      if (!aboveHorizon_[index]) continue;
      result.sum += weightA * weightP * Rgb(table_.values[index]);
      result.weight += weightA * weightP;
    }
  // Between azimuths far apart all four may be below the horizon: then those nearest to the axis that are not.
  for (std::size_t step = p.below; !(result.weight > 0) && step-- > 0;)
    for (const auto& [node, weight] : {std::pair(a.below, 1 - a.fraction), {a.above, a.fraction}}) {
      const std::size_t index = (light * table_.azimuths.size() + node) * table_.polars.size() + step;
      if (!aboveHorizon_[index]) continue;
      result.sum += weight * Rgb(table_.values[index]);
      result.weight += weight;
    }
  return result;
}

Rgb IncidenceTableBrdf::value(const DirectionPair& pair) const {
  const double thetaI = polarAngle(pair.wi);
  const Angle light{std::sqrt(pair.wi.x * pair.wi.x + pair.wi.y * pair.wi.y), pair.wi.z};
  const Place seen = Frame(Axis::mirror, light).place(AzimuthRotation::toZero(pair.wi)(pair.wo));
  const IncidenceBracket bracket = bracketOf(table_.incident, thetaI),
                         about = circleBracket(table_.rotations, isIsotropic() ? 0 : azimuth(pair.wi));
  Weighted result;
  for (const auto& [incident, fraction] :
       {std::pair(bracket.below, 1 - bracket.fraction), {bracket.above, bracket.fraction}}) {
    if (!(fraction > 0)) continue;
    const Angle horizon = horizonOf(incident_[incident], seen.azimuth);
    // The sine of the angle beyond the horizon, which is small where it decides.
    const double beyond = seen.polar.sine * horizon.cosine - seen.polar.cosine * horizon.sine;
    // Between two angles of incidence one of them has the direction above its horizon.
    if (bracket.below != bracket.above && beyond > incidenceTolerance) continue;
    // What is seen of the highlight under this angle of incidence, at the same angles about the mirror direction.
    Place place{beyond > 0 ? horizon : seen.polar, seen.azimuth};
    if (table_.axis == Axis::normal)
      place = Frame(Axis::normal, {}).place(Frame(Axis::mirror, incident_[incident]).direction(place));
    const double polar = place.polarAngle(), turn = place.azimuthAngle();
    for (const auto& [rotation, part] : {std::pair(about.below, 1 - about.fraction), {about.above, about.fraction}}) {
      const double weight = fraction * part;
      if (!(weight > 0)) continue;
      const Weighted found = lookup(rotation * table_.incident.size() + incident, polar, turn);
      if (!(found.weight > 0)) continue;
      result.sum += weight * found.sum / found.weight;
      result.weight += weight;
    }
  }
  return result.weight > 0 ? result.sum / result.weight : Rgb(0);
}

void IncidenceTableBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
  for (std::size_t i = 0; i < pairs.size(); ++i)
    values[i] = isBelowHorizon(pairs[i].wi) || isBelowHorizon(pairs[i].wo) ? Rgb(0) : value(pairs[i]);
}

namespace {

/// Over the angles of incidence and, about the mirror direction, the polar angle; of all azimuths of the light.
class IncidenceBound final : public ValueBound {
 public:
  explicit IncidenceBound(const IncidenceTableBrdf& brdf)
      : incident_(brdf.table().incident),
        isSeamMarked_(!(brdf.table().azimuths.front() > 0) || !(brdf.table().azimuths.back() < 2 * pi)),
        polars_(brdf.table().axis == Axis::mirror ? brdf.table().polars : std::vector<double>{0}),
        extrema_(int(incident_.size()), int(polars_.size())) {
    const IncidenceTable& table = brdf.table();
    for (std::size_t node = 0; node < table.values.size(); ++node) {
      const std::size_t polar = node % table.polars.size();
      // A node below the horizon counts for nothing.
      extrema_.include(int(node / table.polars.size() / table.azimuths.size() % incident_.size()),
                       polars_.size() > 1 ? int(polar) : 0,
                       brdf.isAboveHorizon(node) ? Rgb(table.values[node]) : Rgb(0));
    }
  }

  RgbRange over(const PairBox& box) const override {
    const auto nodes = [](const Range& angle, const std::vector<double>& all) {
      const auto first = std::upper_bound(all.begin(), all.end(), angle.low - incidenceTolerance) - all.begin() - 1;
      const auto last = std::lower_bound(all.begin(), all.end(), angle.high + incidenceTolerance) - all.begin();
      return NodeSpan({double(first), double(last)}, int(all.size()));
    };
    // The mirror direction of the light is that of wi turned by half a turn: 2 sin(angle / 2) is the distance.
    const Range across = Range(2) * box.cosD * box.sinH, distance = sqrt(square(across) + square(box.rise));
    const auto angle = [](double chord) { return 2 * std::asin(std::clamp(chord / 2, 0.0, 1.0)); };
    const Range thetaI = box.thetaI();
    Range polar = increasing(distance, angle);
    // Beyond the first and last angle of incidence, directions below its horizon have values nearer to the axis.
    if (thetaI.low < incident_.front()) polar.low = std::min(polar.low, halfPi - incident_.front());
    if (thetaI.high > incident_.back()) polar.low = std::min(polar.low, halfPi - incident_.back());
    // Without a node at azimuth 0, where the horizon is farthest, all nodes about a direction may be below it.
    if (!isSeamMarked_) polar.low = 0;
    return extrema_.over(nodes(thetaI, incident_), nodes(polar, polars_));
  }
  /// About the normal, the bound is that of a whole angle of incidence.
  bool isLocal() const override { return polars_.size() > 1; }

 private:
  using Axis = IncidenceTable::Axis;
  std::vector<double> incident_;
  bool isSeamMarked_;  ///< whether a node is at azimuth 0
  std::vector<double> polars_;
  GridExtrema extrema_;
};

}  // namespace

std::shared_ptr<const ValueBound> IncidenceTableBrdf::valueBound() const {
  return std::make_shared<const IncidenceBound>(*this);
}

bool IncidenceTableBrdf::hasData(const DirectionPair& pair) const {
  if (!Brdf::hasData(pair)) return false;
  const auto isWithin = [](double angle, const std::vector<double>& nodes) {
    return angle >= nodes.front() - incidenceTolerance && angle <= nodes.back() + incidenceTolerance;
  };
  const double thetaI = polarAngle(pair.wi);
  const Place seen = Frame(table_.axis, angleOf(thetaI)).place(AzimuthRotation::toZero(pair.wi)(pair.wo));
  return isWithin(thetaI, table_.incident) && isWithin(seen.polarAngle(), table_.polars);
}

}  // namespace gonio
