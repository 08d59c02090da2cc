// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>

#include "core/brdf/sampling_lobe.h"
#include "core/brdf/tabulated_brdf.h"

namespace gonio {

/// Range of the valid values of one channel, 1/sr.
struct ChannelRange {
  double min = 0, max = 0;
};

struct TableStatistics {
  std::array<ChannelRange, 3> channels;
  double invalidFraction = 0;  ///< invalid cells / all cells
  double dynamicRange = 0;     ///< largest / smallest positive value of any channel; 0 for a black table
};
TableStatistics tableStatistics(const TabulatedBrdf& table);

/// Directional albedo for a viewer at polar angle `theta` (rad) and azimuth 0: integral of the BRDF times cos theta_i
/// over the hemisphere, per channel, by importance-sampled quadrature with a fixed pattern (deterministic). About 20
/// ms.
Rgb directionalAlbedo(const Brdf& brdf, double theta);
/// The same with a given number of samples and a given lobe, so that estimateSamplingLobe() is called only once for
/// many angles of one BRDF.
Rgb directionalAlbedo(const Brdf& brdf, double theta, SamplingLobe lobe, std::uint32_t sampleCount);

}  // namespace gonio
