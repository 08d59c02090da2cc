// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/marginal_warp.h"

namespace gonio {

/// The field `luminance` of an RGL file for its colours: their luminance, in each slice at least 1/1000 of its largest
/// value (so that no direction is left out), and 1 everywhere where that is 0: the loaders divide by the integral of a
/// slice, and would read NaN.
SliceStack<float> samplingLuminance(const SliceStack<glm::vec3>& rgb);

}  // namespace gonio
