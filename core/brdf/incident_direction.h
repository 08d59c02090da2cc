// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <optional>

#include "core/brdf/brdf.h"

namespace gonio {

/// Which direction of a pair is used as the file's incident direction (the "slot" below). This matters only if the
/// measurement is not reciprocal.
enum class IncidentDirection {
  viewer,  ///< wo, as in Mitsuba and pbrt, which sample the light for a given viewer
  light,   ///< wi, as the file names it
  mean     ///< the mean of both, which is reciprocal
};
inline constexpr IncidentDirection allIncidentDirections[] = {IncidentDirection::viewer, IncidentDirection::light,
                                                              IncidentDirection::mean};
/// The name in files: "viewer", "light" or "mean".
const char* incidentDirectionId(IncidentDirection slot);

/// How an RGL or UTIA file is read; empty for other BRDFs, which have no stored incident direction.
std::optional<IncidentDirection> incidentDirectionOf(const Brdf& brdf);
/// The BRDF read with this slot; the same object if it has the slot already or does not support slots.
std::shared_ptr<const Brdf> withIncident(const std::shared_ptr<const Brdf>& brdf, IncidentDirection slot);

/// The value of a pair when it is read with a slot. @param stored callable as Rgb(incident, outgoing) with the file's
/// own incident and outgoing directions.
template <class Stored>
Rgb valueInOrder(IncidentDirection slot, const DirectionPair& pair, const Stored& stored) {
  switch (slot) {
    case IncidentDirection::light:
      return stored(pair.wi, pair.wo);
    case IncidentDirection::mean:
      return (stored(pair.wo, pair.wi) + stored(pair.wi, pair.wo)) / 2.0;
    default:
      return stored(pair.wo, pair.wi);
  }
}

}  // namespace gonio
