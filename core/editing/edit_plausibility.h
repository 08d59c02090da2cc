// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/editing/edit.h"
#include "core/metrics/plausibility.h"

namespace gonio::editing {

/// Polar angle of Energy::grazing, rad.
inline constexpr double grazingView = radians(80);

/// Luminance of the directional albedo (directionalAlbedo()) for two viewers: the fraction of uniform white light that
/// is reflected to the viewer.
struct Energy {
  double headOn = 0;   ///< viewer at the normal
  double grazing = 0;  ///< viewer at grazingView
};

/// Energies of the base, then of the base with the first 1, 2, ... edits: one entry more than edits. About 20 ms per
/// edit with an effect. @throws Cancelled.
std::vector<Energy> energiesThrough(const std::shared_ptr<const Brdf>& base, std::span<const Edit> edits,
                                    const TaskControl& control = {});

/// Plausibility checks of an edited measurement, in the order "energy", "reciprocity", "negative", "non-finite",
/// "extrapolated". They are those of metrics::checkPlausibility(), except that "negative" examines the values before
/// clamping, and "extrapolated" exists only if `base` is a table. Takes about 100 ms. @throws Cancelled.
std::vector<metrics::PlausibilityCheck> checkEditPlausibility(const std::shared_ptr<const Brdf>& base,
                                                              std::span<const Edit> edits,
                                                              const TaskControl& control = {});

}  // namespace gonio::editing
