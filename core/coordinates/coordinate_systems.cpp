// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/coordinate_systems.h"

#include <algorithm>
#include <string>

#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_out.h"
#include "core/coordinates/projected_deviation.h"
#include "core/support/error.h"

namespace gonio {

namespace {

std::optional<DirectionPair> aboveHorizon(const DirectionPair& pair) {
  if (isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) return std::nullopt;
  return pair;
}

const std::vector<CoordinateSystem>& coordinateTable() {
  static const std::vector<CoordinateSystem> table{
      {"standard",
       "polar angles and azimuths of light and viewer",
       {{"theta_i"}, {"phi_i"}, {"theta_o"}, {"phi_o"}},
       [](const DirectionPair& pair) {
         return std::vector{polarAngle(pair.wi), azimuth(pair.wi), polarAngle(pair.wo), azimuth(pair.wo)};
       },
       [](std::span<const double> v) {
         return aboveHorizon({fromSpherical(v[0], v[1]), fromSpherical(v[2], v[3])});
       }},
      {"half-difference",
       "Rusinkiewicz 1998",
       {{"theta_h"}, {"theta_d"}, {"phi_d"}},
       [](const DirectionPair& pair) {
         const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
         return std::vector{at.thetaH, at.thetaD, at.phiD};
       },
       [](std::span<const double> v) { return aboveHorizon(fromHalfDifference(v[0], v[1], v[2])); }},
      {"half-out",
       "Lawrence et al. 2004",
       {{"theta_o"}, {"theta_h"}, {"phi_h"}},
       [](const DirectionPair& pair) {
         const HalfOut at = toHalfOut(pair.wi, pair.wo);
         return std::vector{at.thetaO, at.thetaH, at.phiH};
       },
       [](std::span<const double> v) {
         const HalfOutDirections found = fromHalfOut({.thetaO = v[0], .thetaH = v[1], .phiH = v[2], .valid = true});
         return found.valid ? aboveHorizon(found.pair) : std::nullopt;
       }},
      {"projected-deviation",
       "Tongbuasirilai et al. 2017",
       {{"theta_r"}, {"deviation", false}, {"phi"}},
       [](const DirectionPair& pair) {
         const ProjectedDeviation at = toProjectedDeviation(pair.wi, pair.wo);
         return std::vector{at.thetaR, at.deviation, at.phi};
       },
       [](std::span<const double> v) {
         const ProjectedDirections found = fromProjectedDeviation({v[0], v[1], v[2]});
         return found.valid ? aboveHorizon(found.pair) : std::nullopt;
       }}};
  return table;
}

}  // namespace

std::span<const CoordinateSystem> coordinateSystems() { return coordinateTable(); }

const CoordinateSystem& coordinateSystemNamed(std::string_view id) {
  const std::span<const CoordinateSystem> systems = coordinateSystems();
  const auto found = std::ranges::find(systems, id, &CoordinateSystem::id);
  if (found != systems.end()) return *found;
  std::string names;
  for (const CoordinateSystem& system : systems) names += (names.empty() ? "" : ", ") + std::string(system.id);
  throw Error("coordinates: found '" + std::string(id) + "', expected one of: " + names);
}

}  // namespace gonio
