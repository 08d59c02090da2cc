// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/section.h"
#include "core/support/task_control.h"

namespace gonio::plots {

/// Directional albedo (the integral of f cos theta_i over the light's hemisphere, without unit) for viewers at azimuth
/// 0 and polar angles from 0 to 89 degrees, denser toward grazing. Directions without data count as 0. Parallel,
/// deterministic; about 20 ms per angle on one core with the default number of samples. @param count number of angles.
/// @param samples per integral. @throws Cancelled.
Curve albedoCurve(const Brdf& brdf, int count = 31, int samples = 1 << 14, const TaskControl& control = {});

}  // namespace gonio::plots
