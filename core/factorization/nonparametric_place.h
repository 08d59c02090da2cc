// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/factorization/nonparametric.h"
#include "core/math/monotone_cubic.h"

namespace gonio::factorization {

/// The place between two nodes of a position in units of nodes, clamped to the ends.
NodePlace nonparametricPlace(double position);
/// The place of a polar angle (rad) between two nodes of G.
inline NodePlace maskingPlace(double theta) { return nonparametricPlace(degrees(theta) - 0.5); }

}  // namespace gonio::factorization
