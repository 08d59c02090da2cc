// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/math/types.h"

namespace gonio::io {

/// A measurement at scattered pairs of directions, without a grid: the result of readers of such formats.
/// core/materials/scattered_material.h converts it to a material.
struct ScatteredSamples {
  std::vector<DirectionPair> directions;  ///< both above the horizon
  std::vector<Rgb> values;                ///< linear RGB, 1/sr, without the cosine, finite and >= 0; one per pair
  std::vector<Rgb> standardDeviations;    ///< of the values, 1/sr; empty if unknown
  std::size_t clampedCount = 0;           ///< number of channel values that were below 0 and were set to 0
  std::size_t belowHorizonCount = 0;      ///< number of rows that were ignored because a direction is at or below the
                                          ///< horizon
  std::string description;                ///< of the sample, from the file; may be empty

  /// Adds a row, or only counts it if a direction is at or below the horizon. @param value finite; negative channels
  /// become 0 and are counted.
  void add(const DirectionPair& pair, const Rgb& value) {
    if (!(pair.wi.z > horizonTolerance && pair.wo.z > horizonTolerance)) {
      ++belowHorizonCount;
      return;
    }
    Rgb clamped = value;
    for (int channel = 0; channel < 3; ++channel)
      if (clamped[channel] < 0) {
        clamped[channel] = 0;
        ++clampedCount;
      }
    directions.push_back(pair);
    values.push_back(clamped);
  }
};

}  // namespace gonio::io
