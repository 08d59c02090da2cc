// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio::editing {

/// The pair of directions whose half vector has `scale` times the tangent of the polar angle, with the same theta_d and
/// phi_d: both directions are turned in the plane of the normal and the half vector. A turn that would bring one below
/// the horizon ends just above it. Identical for a scale of 1, and where the half vector is the normal.
/// @param pair with both directions above the horizon. @param scale > 0.
DirectionPair withScaledHalfTangent(const DirectionPair& pair, double scale);

}  // namespace gonio::editing
