// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/incident_direction.h"

#include "core/brdf/rgl_brdf.h"
#include "core/brdf/utia_brdf.h"

namespace gonio {

const char* incidentDirectionId(IncidentDirection incident) {
  switch (incident) {
    case IncidentDirection::light:
      return "light";
    case IncidentDirection::mean:
      return "mean";
    default:
      return "viewer";
  }
}

std::optional<IncidentDirection> incidentDirectionOf(const Brdf& brdf) {
  if (const RglBrdf* rgl = brdf.asRgl()) return rgl->incidentDirection();
  if (const auto* utia = dynamic_cast<const UtiaBrdf*>(&brdf)) return utia->incidentDirection();
  return std::nullopt;
}

std::shared_ptr<const Brdf> withIncident(const std::shared_ptr<const Brdf>& brdf, IncidentDirection incident) {
  if (incidentDirectionOf(*brdf).value_or(incident) == incident) return brdf;
  if (const RglBrdf* rgl = brdf->asRgl()) return rgl->withIncident(incident);
  return dynamic_cast<const UtiaBrdf&>(*brdf).withIncident(incident);
}

}  // namespace gonio
