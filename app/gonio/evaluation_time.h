// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/brdf.h"

namespace gonio::app {

/// Nanoseconds of one evaluation on one core: the fastest of some runs over directions that are spread over both
/// hemispheres, on this machine now.
double evaluationNanoseconds(const Brdf& brdf);

}  // namespace gonio::app
