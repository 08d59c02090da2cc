// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>

#include "core/sampling/fitted_densities.h"

namespace gonio {

/// Directional albedo for a viewer at polar angle `theta` (rad) and azimuth 0: integral of the BRDF times cos theta_i
/// over the hemisphere, per channel, by importance-sampled quadrature with a fixed pattern (deterministic). About 20
/// ms.
Rgb directionalAlbedo(const Brdf& brdf, double theta);
/// The same with a given number of samples and a given density, so that estimateSamplingDensity() is called only once
/// for many angles of one BRDF.
Rgb directionalAlbedo(const Brdf& brdf, double theta, SamplingDensity density, std::uint32_t sampleCount);

}  // namespace gonio
