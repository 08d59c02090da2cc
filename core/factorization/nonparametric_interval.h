// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/factorization/nonparametric.h"
#include "core/math/monotone_cubic.h"

namespace gonio::factorization {

/// The two nodes around a position (in units of nodes) and the fraction between them, clamped to the ends.
NodeInterval nonparametricInterval(double position);
/// The two nodes of G around a polar angle (rad), and the fraction between them.
inline NodeInterval maskingInterval(double theta) { return nonparametricInterval(degrees(theta) - 0.5); }

}  // namespace gonio::factorization
