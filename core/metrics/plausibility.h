// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/brdf/tabulated_brdf.h"

namespace gonio::metrics {

/// One test of physical plausibility. `worst` is the largest violation in the unit that the check's name implies:
///   "reciprocity"   |f(i,o) - f(o,i)| / max(f(i,o), f(o,i)), largest channel
///   "energy"        directional albedo, largest channel (reported when it passes, too)
///   "negative"      -f, 1/sr
///   "non-finite"    count of the directions with such a value
///   "extrapolated"  fraction of what a picture shows that lies where the table has no data
struct PlausibilityCheck {
  std::string name;
  bool passed = true;
  double worst = 0;
  double limit = 0;     ///< passed while `worst` is at most this
  double fraction = 0;  ///< of the directions that were tried: beyond the limit, [0, 1]
  /// Where the worst is: the light and the viewer. For "energy" the viewer's angle counts alone (wi is the normal).
  std::optional<DirectionPair> at = {};
  std::string where = {};  ///< `at` in degrees for people
};

/// Reciprocity |f(i,o) - f(o,i)| <= 2 % of the larger value's scale, albedo <= 1 + 1 % at 0..85 degrees, no negative
/// and no non-finite values, over a fixed deterministic set of directions. Of an RGL file, which may hold colours
/// outside the sRGB gamut, the luminance must not be negative. Some 100 ms. @throws Cancelled.
std::vector<PlausibilityCheck> checkPlausibility(const Brdf& brdf, const TaskControl& control = {});

/// "negative" alone, for edits that are clamped before they are shown: values that are below 0, and below those of the
/// base, by more than a millionth of the mean count.
PlausibilityCheck checkNegative(const Brdf& edited, const Brdf& base);

/// "extrapolated": pairs of directions up to 85 degrees, weighed by both cosines, whose nearest cell is invalid: they
/// are shown black or take the values of neighbours. At most 1 % passes. `at` is the pair nearest to the normal.
PlausibilityCheck checkCoverage(const TabulatedBrdf& table);

}  // namespace gonio::metrics
