// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/incident_slot.h"

#include "core/brdf/rgl_brdf.h"
#include "core/brdf/utia_brdf.h"

namespace gonio {

const char* incidentSlotId(IncidentSlot slot) {
  switch (slot) {
    case IncidentSlot::light:
      return "light";
    case IncidentSlot::mean:
      return "mean";
    default:
      return "viewer";
  }
}

std::optional<IncidentSlot> incidentSlotOf(const Brdf& brdf) {
  if (const RglBrdf* rgl = brdf.asRgl()) return rgl->incidentSlot();
  if (const auto* utia = dynamic_cast<const UtiaBrdf*>(&brdf)) return utia->incidentSlot();
  return std::nullopt;
}

std::shared_ptr<const Brdf> withIncident(const std::shared_ptr<const Brdf>& brdf, IncidentSlot slot) {
  if (incidentSlotOf(*brdf).value_or(slot) == slot) return brdf;
  if (const RglBrdf* rgl = brdf->asRgl()) return rgl->withIncident(slot);
  return dynamic_cast<const UtiaBrdf&>(*brdf).withIncident(slot);
}

}  // namespace gonio
