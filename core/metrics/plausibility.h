// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/brdf/tabulated_brdf.h"

namespace gonio::metrics {

/// One check of physical plausibility. `worst` is the largest violation; its meaning depends on `name`:
///   "reciprocity" largest channel of |f(i,o) - f(o,i)|, divided by the largest channel of f(i,o) and f(o,i), or by 5 %
///                 of the mean value if that is larger
///   "energy" directional albedo, largest channel (also reported if the check passes), for viewers at 0, 15, 30, 45,
///   60,
///            75 and 85 degrees and at the whole degrees between with the largest narrow peaks (narrowPeaks())
///   "negative" -f, 1/sr
///   "non-finite" number of directions with such a value
///   "extrapolated" fraction of the tested direction pairs without data in the table, weighted by both cosines
struct PlausibilityCheck {
  std::string name;
  bool passed = true;
  double worst = 0;
  double limit = 0;     ///< the check passes if `worst` is at most this
  double fraction = 0;  ///< fraction of the tested directions beyond the limit, [0, 1]
  /// Directions of `worst`. For "energy" only wo is meaningful (wi is the normal).
  std::optional<DirectionPair> at = {};
  std::string where = {};  ///< `at` in degrees, as text
};

/// Checks reciprocity (relative difference at most 2 %), energy (albedo at most 1.01 for viewers at 0 to 85 degrees),
/// negative and non-finite values, over a fixed set of directions, to which "energy" adds those of narrow peaks. For an
/// RGL file, which may contain colours outside the sRGB gamut, "negative" tests the luminance. Takes about 0.2 s.
/// @throws Cancelled.
std::vector<PlausibilityCheck> checkPlausibility(const Brdf& brdf, const TaskControl& control = {});

/// The check "negative" for edits before clamping: counts values that are below 0 and below the base's value by more
/// than a millionth of the mean value.
PlausibilityCheck checkNegative(const Brdf& edited, const Brdf& base);

/// The check "extrapolated": the fraction of the tested direction pairs (up to 85 degrees, half of them near the mirror
/// direction), weighted by both cosines, that lie in an invalid cell (TableLookup::cell). Values there are 0 or those
/// of neighbouring nodes. Passes up to 1 %. `at` is the pair with the largest weight.
PlausibilityCheck checkCoverage(const TabulatedBrdf& table);

}  // namespace gonio::metrics
