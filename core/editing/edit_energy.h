// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/editing/edit.h"

namespace gonio::editing {

/// Polar angle at which the energy toward the edge is stated, rad.
inline constexpr double grazingView = radians(80);

/// Directional albedo (directionalAlbedo()) as luminance: the fraction of white light from everywhere that is sent to a
/// viewer.
struct Energy {
  double headOn = 0;   ///< viewer at the normal
  double grazing = 0;  ///< viewer at grazingView
};

/// Of the base, and of it with the first 1, 2, ... edits: one more than there are edits. About 20 ms each that changes
/// something. @throws Cancelled.
std::vector<Energy> energiesThrough(const std::shared_ptr<const Brdf>& base, std::span<const Edit> edits,
                                    const TaskControl& control = {});

}  // namespace gonio::editing
