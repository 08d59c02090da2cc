// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_source.h"

#include <cmath>
#include <cstdio>

#include "core/brdf/statistics.h"

namespace gonio::exports {

std::vector<std::string> exportWarnings(const Brdf& material) {
  constexpr double allowed = 1.001;  // the error of the quadrature
  double worst = 0, where = 0;
  for (const double theta : {0.0, 30.0, 60.0, 80.0})
    if (const double albedo = maxChannel(directionalAlbedo(material, radians(theta))); albedo > worst) {
      worst = albedo;
      where = theta;
    }
  if (!(worst > allowed)) return {};
  char text[160];
  std::snprintf(text, sizeof text,
                "the material reflects more light than it receives: albedo %.3f for a viewer at %.0f degrees", worst,
                where);
  return {text};
}

}  // namespace gonio::exports
