// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/editing/edit.h"
#include "core/metrics/plausibility.h"

namespace gonio::editing {

/// Plausibility checks of an edited measurement, in the order "energy", "reciprocity", "negative", "non-finite",
/// "extrapolated". They are those of metrics::checkPlausibility(), except that "negative" examines the values before
/// clamping, and "extrapolated" exists only if `base` is a table. Takes about 100 ms. @throws Cancelled.
std::vector<metrics::PlausibilityCheck> checkEditPlausibility(const std::shared_ptr<const Brdf>& base,
                                                              std::span<const Edit> edits,
                                                              const TaskControl& control = {});

}  // namespace gonio::editing
