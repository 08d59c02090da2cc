// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgl_description.h"

#include <cmath>
#include <cstdio>

namespace gonio::exports {

std::string describe(const std::string& origin, double snr, std::size_t clipped) {
  char ratio[64] = "exact (values of the source)";
  if (std::isfinite(snr)) std::snprintf(ratio, sizeof ratio, "rendered SNR %.1f dB (comparison scene)", snr);
  return origin +
         ". The incident direction (theta_i, phi_i) is that of the viewer, as in Mitsuba and pbrt. Accuracy: " + ratio +
         "; " + std::to_string(clipped) + " negative values set to 0.";
}

}  // namespace gonio::exports
