// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_axes.h"

#include <algorithm>
#include <string>

#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_out.h"
#include "core/coordinates/projected_deviation.h"
#include "core/support/error.h"

namespace gonio::acquisition {

FactorAxes factorAxesNamed(std::string_view name) {
  const auto found = std::ranges::find(factorAxesNames, name);
  if (found == factorAxesNames.end())
    throw Error("factor axes: found '" + std::string(name) +
                "', expected projected-deviation, symmetric-deviation, half-difference or half-out");
  return FactorAxes(found - factorAxesNames.begin());
}

FactorCoordinates toFactorCoordinates(FactorAxes axes, const DirectionPair& pair) {
  switch (axes) {
    case FactorAxes::projectedDeviation: {
      const ProjectedDeviation at = toProjectedDeviation(pair.wi, pair.wo);
      return {at.thetaR, at.deviation};
    }
    case FactorAxes::symmetricDeviation:
      return {toHalfDifference(pair.wi, pair.wo).thetaD, toProjectedDeviation(pair.wi, pair.wo).deviation};
    case FactorAxes::halfDifference: {
      const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
      return {at.thetaD, at.thetaH};
    }
    default: {
      const HalfOut at = toHalfOut(pair.wi, pair.wo);
      return {at.thetaO, at.thetaH};
    }
  }
}

std::optional<DirectionPair> fromFactorCoordinates(FactorAxes axes, const FactorCoordinates& place) {
  if (isDeviation(axes)) {
    const ProjectedDirections found = fromProjectedDeviation({place.angle, place.distance, 0});
    return found.valid ? std::optional(found.pair) : std::nullopt;
  }
  if (axes == FactorAxes::halfOut) {
    const HalfOutDirections found =
        fromHalfOut({.thetaO = place.angle, .thetaH = place.distance, .phiH = 0, .valid = true});
    return found.valid ? std::optional(found.pair) : std::nullopt;
  }
  const DirectionPair pair = fromHalfDifference(place.distance, place.angle, 0);
  if (isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) return std::nullopt;
  return pair;
}

}  // namespace gonio::acquisition
