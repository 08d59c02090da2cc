// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/editing/edit.h"
#include "core/metrics/plausibility.h"

namespace gonio::editing {

/// The checks of an edited measurement, in the order "energy", "reciprocity", "negative", "non-finite",
/// "extrapolated": as metrics::checkPlausibility(), but negative values are judged before they are clamped, and
/// "extrapolated" is there where `base` is a table. Some 100 ms. @throws Cancelled.
std::vector<metrics::PlausibilityCheck> checkEditPlausibility(const std::shared_ptr<const Brdf>& base,
                                                              std::span<const Edit> edits,
                                                              const TaskControl& control = {});

}  // namespace gonio::editing
