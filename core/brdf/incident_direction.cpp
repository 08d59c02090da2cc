// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/incident_direction.h"

#include "core/brdf/rgl_brdf.h"
#include "core/brdf/utia_brdf.h"

namespace gonio {

const char* incidentDirectionId(IncidentDirection slot) {
  switch (slot) {
    case IncidentDirection::light:
      return "light";
    case IncidentDirection::mean:
      return "mean";
    default:
      return "viewer";
  }
}

std::optional<IncidentDirection> incidentDirectionOf(const Brdf& brdf) {
  if (const RglBrdf* rgl = brdf.asRgl()) return rgl->incidentSlot();
  if (const auto* utia = dynamic_cast<const UtiaBrdf*>(&brdf)) return utia->incidentSlot();
  return std::nullopt;
}

std::shared_ptr<const Brdf> withIncident(const std::shared_ptr<const Brdf>& brdf, IncidentDirection slot) {
  if (incidentDirectionOf(*brdf).value_or(slot) == slot) return brdf;
  if (const RglBrdf* rgl = brdf->asRgl()) return rgl->withIncident(slot);
  return dynamic_cast<const UtiaBrdf&>(*brdf).withIncident(slot);
}

}  // namespace gonio
