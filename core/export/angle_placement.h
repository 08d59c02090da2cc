// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/rgl_sampler.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// Chooses polar angles of the incident direction, rad, from 0 to 89 degrees, densely where the material changes.
/// Starts with four angles and repeatedly halves the interval with the largest error of linear interpolation at its
/// middle: the error of the field `rgb`, weighted by the area of the part of a sphere's picture that is seen at angles
/// in this interval. Cost: two slices of 16 x 16 nodes per angle. @param count at least 4. @return the angles in the
/// order in which they were added, so that the first n >= 4 of them are the result for n. @throws Cancelled.
std::vector<double> placeAngles(const Brdf& material, const RglLayout& layout, std::size_t count,
                                const TaskControl& control = {});

}  // namespace gonio::exports
