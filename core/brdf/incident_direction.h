// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio {

/// Which direction of a pair is used as the file's incident direction. This matters only if the measurement is not
/// reciprocal.
enum class IncidentDirection {
  viewer,  ///< wo, as in Mitsuba and pbrt, which sample the light for a given viewer
  light,   ///< wi, as the file names it
  mean     ///< the mean of both, which is reciprocal
};
inline constexpr IncidentDirection allIncidentDirections[] = {IncidentDirection::viewer, IncidentDirection::light,
                                                              IncidentDirection::mean};
/// The name in files: "viewer", "light" or "mean".
constexpr const char* incidentDirectionId(IncidentDirection incident) {
  return incident == IncidentDirection::light ? "light" : incident == IncidentDirection::mean ? "mean" : "viewer";
}

/// The value of a pair when it is read with an incident direction. @param stored callable as Rgb(incident, outgoing)
/// with the file's own incident and outgoing directions.
template <class Stored>
Rgb valueInOrder(IncidentDirection incident, const DirectionPair& pair, const Stored& stored) {
  switch (incident) {
    case IncidentDirection::light:
      return stored(pair.wi, pair.wo);
    case IncidentDirection::mean:
      return (stored(pair.wo, pair.wi) + stored(pair.wi, pair.wo)) / 2.0;
    default:
      return stored(pair.wo, pair.wi);
  }
}

}  // namespace gonio
