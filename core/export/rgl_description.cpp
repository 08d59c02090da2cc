// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgl_description.h"

#include <cmath>
#include <cstdio>

namespace gonio::exports {

std::string describe(const std::string& origin, double snr, std::size_t clipped) {
  char ratio[64] = "the source's own values";
  if (std::isfinite(snr)) std::snprintf(ratio, sizeof ratio, "rendered SNR %.1f dB (sphere-studio)", snr);
  return origin +
         ". Incident direction (theta_i, phi_i): the viewer's, as Mitsuba and pbrt read it. Accuracy: " + ratio + "; " +
         std::to_string(clipped) + " negative values set to 0.";
}

}  // namespace gonio::exports
