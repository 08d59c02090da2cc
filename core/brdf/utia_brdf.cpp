// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/utia_brdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/brdf/value_bound.h"
#include "core/support/error.h"

namespace gonio {

namespace {

constexpr std::size_t utiaDirections = UtiaBrdf::directionCount, utiaAzimuths = UtiaBrdf::azimuthCount;

/// Rounding of directions at the last polar angle.
constexpr double angleTolerance = 1e-9;

/// The four nodes about a direction with their weights, which sum to 1.
struct UtiaNodes {
  std::array<std::size_t, 4> index;
  std::array<double, 4> weight;

  explicit UtiaNodes(const Direction& w) {
    const double theta = std::min(polarAngle(w), UtiaBrdf::maxPolarAngle) / UtiaBrdf::polarStep;
    const auto below = std::min(std::size_t(theta), UtiaBrdf::polarCount - 2);
    const double turn = azimuth(w) / UtiaBrdf::azimuthStep, floor = std::floor(turn);
    const std::size_t left = std::size_t(floor + double(utiaAzimuths)) % utiaAzimuths,
                      right = (left + 1) % utiaAzimuths;
    const double up = theta - double(below), aside = turn - floor;
    index = {below * utiaAzimuths + left, below * utiaAzimuths + right, (below + 1) * utiaAzimuths + left,
             (below + 1) * utiaAzimuths + right};
    weight = {(1 - up) * (1 - aside), (1 - up) * aside, up * (1 - aside), up * aside};
  }
};

/// Replaces values at polar angle 0, `stride` apart from `first`, by their mean.
void unitePole(std::vector<glm::vec3>& values, std::size_t first, std::size_t stride) {
  glm::dvec3 mean(0);
  for (std::size_t azimuth = 0; azimuth < utiaAzimuths; ++azimuth) mean += glm::dvec3(values[first + azimuth * stride]);
  mean /= double(utiaAzimuths);
  for (std::size_t azimuth = 0; azimuth < utiaAzimuths; ++azimuth) values[first + azimuth * stride] = mean;
}

void checkUtia(const std::vector<glm::vec3>& values) {
  if (values.size() != utiaDirections * utiaDirections)
    throw Error("found " + std::to_string(values.size()) + " values, expected 288 x 288");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i].x + values[i].y + values[i].z))
      throw Error("the value of incident direction " + std::to_string(i / utiaDirections) + " and viewing direction " +
                  std::to_string(i % utiaDirections) + " is not a finite number");
}

/// The value at the file's own incident and viewing directions.
Rgb storedValues(const UtiaBrdf::Values& values, const Direction& incident, const Direction& viewing) {
  const UtiaNodes rows(incident), columns(viewing);
  Rgb value(0);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t v = 0; v < 4; ++v)
      value += rows.weight[i] * columns.weight[v] * Rgb(values[rows.index[i] * utiaDirections + columns.index[v]]);
  return value;
}

}  // namespace

UtiaBrdf::UtiaBrdf(std::vector<glm::vec3> values, IncidentDirection incident) : incident_(incident) {
  checkUtia(values);
  for (glm::vec3& value : values)
    for (int channel = 0; channel < 3; ++channel) {
      clampedCount_ += value[channel] < 0;
      value[channel] = std::max(value[channel], 0.0f);
    }
  for (std::size_t other = 0; other < utiaDirections; ++other) unitePole(values, other, utiaDirections);
  for (std::size_t other = 0; other < utiaDirections; ++other) unitePole(values, other * utiaDirections, 1);
  values_ = std::make_shared<const Values>(std::move(values));
}

std::shared_ptr<const UtiaBrdf> UtiaBrdf::withIncident(IncidentDirection incident) const {
  return std::shared_ptr<const UtiaBrdf>(new UtiaBrdf(*this, incident));
}

void UtiaBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
  const auto value = [this](const Direction& incident, const Direction& viewing) {
    return storedValues(*values_, incident, viewing);
  };
  for (std::size_t p = 0; p < pairs.size(); ++p)
    values[p] =
        isBelowHorizon(pairs[p].wi) || isBelowHorizon(pairs[p].wo) ? Rgb(0) : valueInOrder(incident_, pairs[p], value);
}

namespace {

/// Over both polar angles and the difference of the azimuths, whatever the azimuth of the incident direction.
class UtiaBound final : public ValueBound {
 public:
  UtiaBound(const UtiaBrdf::Values& values, IncidentDirection incident) : extrema_(polars * polars, azimuths) {
    const auto include = [&](int viewer, int light, int turn, const glm::vec3& value) {
      // Both azimuths are interpolated: the nodes' difference is up to a step from that of the directions.
      for (const int step : {-1, 0, 1})
        extrema_.include(viewer * polars + light, (turn + step + azimuths) % azimuths, Rgb(value));
    };
    for (int i = 0; i < directions; ++i)
      for (int v = 0; v < directions; ++v) {
        const glm::vec3& value = values[std::size_t(i * directions + v)];
        const int in = i / azimuths, out = v / azimuths, turn = (v - i + 2 * directions) % azimuths;
        if (incident != IncidentDirection::light) include(in, out, turn, value);
        if (incident != IncidentDirection::viewer) include(out, in, (azimuths - turn) % azimuths, value);
      }
  }

  RgbRange over(const PairBox& box) const override {
    const NodeSpan viewer(scaled(box.thetaO, UtiaBrdf::polarStep), polars),
        light(scaled(box.thetaI(), UtiaBrdf::polarStep), polars);
    const Range turn = scaled(box.phiI(), UtiaBrdf::azimuthStep);
    const int first = int(std::floor(turn.low - 1e-6)), last = int(std::ceil(turn.high + 1e-6));
    const int count = std::min(last - first + 1, azimuths);
    RgbRange result{Rgb(std::numeric_limits<double>::max()), Rgb(0)};
    for (int out = viewer.first; out <= viewer.last; ++out)
      for (int in = light.first; in <= light.last; ++in)
        for (int n = 0; n < count; ++n) {
          const int at = ((first + n) % azimuths + azimuths) % azimuths, row = out * polars + in;
          const RgbRange cell = extrema_.over(NodeSpan(double(row), polars * polars), NodeSpan(double(at), azimuths));
          result.low = glm::min(result.low, cell.low);
          result.high = glm::max(result.high, cell.high);
        }
    return result;
  }

 private:
  static constexpr int polars = int(UtiaBrdf::polarCount), azimuths = int(UtiaBrdf::azimuthCount),
                       directions = polars * azimuths;
  static Range scaled(const Range& angle, double step) { return {angle.low / step, angle.high / step}; }

  GridExtrema extrema_;
};

}  // namespace

std::shared_ptr<const ValueBound> UtiaBrdf::valueBound() const {
  return std::make_shared<const UtiaBound>(*values_, incident_);
}

bool UtiaBrdf::hasData(const DirectionPair& pair) const {
  return Brdf::hasData(pair) && polarAngle(pair.wi) <= maxPolarAngle + angleTolerance &&
         polarAngle(pair.wo) <= maxPolarAngle + angleTolerance;
}

std::vector<DirectionPair> UtiaBrdf::nodes(std::size_t incident) {
  const auto direction = [](std::size_t index) {
    return fromSpherical(polarStep * double(index / azimuthCount), azimuthStep * double(index % azimuthCount));
  };
  std::vector<DirectionPair> pairs;
  for (std::size_t i = 0; i < directionCount; ++i) pairs.push_back({direction(i), direction(incident)});
  return pairs;
}

}  // namespace gonio
