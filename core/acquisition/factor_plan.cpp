// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_plan.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/support/error.h"
#include "core/support/number_text.h"

namespace gonio::acquisition {

namespace {

constexpr int maxReadings = 2'000;
constexpr std::string_view methodPrefix = "factors, ";

void checkOptions(const FactorPlanOptions& o) {
  if (!(o.maxPolarAngle > 0 && o.maxPolarAngle < halfPi))
    throw Error("factor measurement: found the maximum polar angle " + numberText(degrees(o.maxPolarAngle)) +
                " degrees, expected above 0 and below 90");
  if (!(o.fixedAngle >= 0 && o.fixedAngle <= o.maxPolarAngle))
    throw Error("factor measurement: found the fixed angle " + numberText(degrees(o.fixedAngle)) +
                " degrees, expected from 0 to the maximum polar angle, " + numberText(degrees(o.maxPolarAngle)));
  for (const int count : {o.angles, o.distances})
    if (count < 2 || count > maxReadings)
      throw Error("factor measurement: found " + std::to_string(count) + " readings of a curve, expected 2 to " +
                  std::to_string(maxReadings));
  if (!(o.minSeparation >= 0 && o.minSeparation <= pi))
    throw Error("factor measurement: found the minimum separation of the arms " + numberText(degrees(o.minSeparation)) +
                " degrees, expected from 0 to 180");
}

/// Appends the reading at a place, or counts it as blocked.
void plan(FactorCurve curve, const FactorCoordinates& place, const FactorPlanOptions& options, FactorPlan& result) {
  const std::optional<DirectionPair> arms = fromFactorCoordinates(options.axes, place);
  const double lowest = std::cos(options.maxPolarAngle) * (1 - 1e-9);
  if (!arms || arms->wi.z < lowest || arms->wo.z < lowest ||
      glm::length(arms->wi - arms->wo) < 2 * std::sin(options.minSeparation / 2)) {
    ++result.blocked;
    return;
  }
  const int index = int(result.plan.samples.size()) + 1;
  result.plan.samples.push_back({index, *arms, index});
  result.curves.push_back(curve);
}

}  // namespace

FactorPlan planFactors(const FactorPlanOptions& options) {
  checkOptions(options);
  FactorPlan result{.axes = options.axes, .plan = {}, .curves = {}};
  result.plan.method = factorMethod(options.axes);
  for (int i = 0; i < options.angles; ++i)
    plan(FactorCurve::along, {options.maxPolarAngle * i / (options.angles - 1), 0}, options, result);
  const std::size_t along = result.curves.size();
  const double last = isDeviation(options.axes) ? 2 : halfPi;
  for (int j = 0; j < options.distances; ++j) {
    const double fraction = double(j) / (options.distances - 1);
    plan(FactorCurve::across, {options.fixedAngle, last * fraction * fraction}, options, result);
  }
  if (along == 0 || along == result.curves.size())
    throw Error("factor measurement: the rig reaches no reading of the curve \"" +
                std::string(factorCurveNames[std::size_t(along == 0 ? FactorCurve::along : FactorCurve::across)]) +
                "\": each is below the horizon, beyond the maximum polar angle or obstructed by the other arm");
  return result;
}

std::string factorMethod(FactorAxes axes) {
  return std::string(methodPrefix) + std::string(factorAxesNames[std::size_t(axes)]);
}

std::optional<FactorAxes> axesOfFactorMethod(std::string_view method) {
  if (!method.starts_with(methodPrefix)) return std::nullopt;
  const auto found = std::ranges::find(factorAxesNames, method.substr(methodPrefix.size()));
  if (found == factorAxesNames.end()) return std::nullopt;
  return FactorAxes(found - factorAxesNames.begin());
}

int plannedReadings(std::span<const double> angles) {
  constexpr double tolerance = 0.01;  // of the spacing
  const int count = int(angles.size());
  if (count < 2) return count;
  const double spacing = (angles.back() - angles.front()) / (count - 1);
  for (int i = 0; i < count; ++i)
    if (std::abs(angles[std::size_t(i)] - angles.front() - i * spacing) > tolerance * spacing) return count;
  const double before = angles.front() / spacing;
  return std::abs(before - std::round(before)) > tolerance ? count : count + int(std::lround(before));
}

}  // namespace gonio::acquisition
