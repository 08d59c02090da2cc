// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/section.h"
#include "core/support/task_control.h"

namespace gonio::plots {

/// Directional albedo (a plain number: the integral of f cos theta_i over the light's hemisphere) against the polar
/// angle of the viewer, 0 to 89 degrees, denser toward grazing. Where a measurement has no data it counts as 0.
/// `samples` of each integral; in parallel, deterministic. About 20 ms an angle with the default on one core.
/// @throws Cancelled.
Curve albedoCurve(const Brdf& brdf, int count = 31, int samples = 1 << 14, const TaskControl& control = {});

}  // namespace gonio::plots
