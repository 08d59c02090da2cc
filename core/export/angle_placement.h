// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/rgl_sampler.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// Polar angles of the incident direction (rad, 0 to 89 degrees) placed where the material changes: from a few, the
/// interval whose linear interpolation errs most at its middle is split, again and again. The error is that of the
/// field `rgb`, which is reflected light, times the area that the angle has on a sphere.
/// @return in the order in which they were added: the first n of them are a set for every n >= 4.
/// @throws Cancelled. Two slices of 16 x 16 nodes per angle.
std::vector<double> placeAngles(const Brdf& material, const RglLayout& layout, std::size_t count,
                                const TaskControl& control = {});

}  // namespace gonio::exports
