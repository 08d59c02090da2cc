// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/factorization/nonparametric.h"
#include "core/math/monotone_cubic.h"

namespace gonio::factorization {

/// Where a position counted in nodes lies between them; held at the ends.
NodePlace nonparametricPlace(double position);
/// Where a polar angle (rad) lies between the nodes of G.
inline NodePlace maskingPlace(double theta) { return nonparametricPlace(degrees(theta) - 0.5); }

}  // namespace gonio::factorization
