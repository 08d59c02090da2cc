// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <optional>

#include "core/brdf/brdf.h"

namespace gonio {

/// Which direction takes the place of a file's incident direction. It matters where a measurement is not reciprocal.
enum class IncidentSlot {
  viewer,  ///< wo, as in Mitsuba and pbrt, which sample the light from the viewer
  light,   ///< wi, as the file names it
  mean     ///< the mean of both, which is reciprocal
};
inline constexpr IncidentSlot allIncidentSlots[] = {IncidentSlot::viewer, IncidentSlot::light, IncidentSlot::mean};
/// "viewer", "light", "mean": in files.
const char* incidentSlotId(IncidentSlot slot);

/// The slot of a measurement that can be read in any order (RGL and UTIA files); nothing for all other BRDFs.
std::optional<IncidentSlot> incidentSlotOf(const Brdf& brdf);
/// A BRDF with this direction in the slot; the same object where it has the slot already, or no choice of it.
std::shared_ptr<const Brdf> withIncident(const std::shared_ptr<const Brdf>& brdf, IncidentSlot slot);

/// The value of a pair in an order. @param stored the value at the file's own incident and outgoing directions.
template <class Stored>
Rgb valueInOrder(IncidentSlot slot, const DirectionPair& pair, const Stored& stored) {
  switch (slot) {
    case IncidentSlot::light:
      return stored(pair.wi, pair.wo);
    case IncidentSlot::mean:
      return (stored(pair.wo, pair.wi) + stored(pair.wi, pair.wo)) / 2.0;
    default:
      return stored(pair.wo, pair.wi);
  }
}

}  // namespace gonio
