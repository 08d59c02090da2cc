// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/marginal_warp.h"

namespace gonio {

/// The field `luminance` of an RGL file for a field `rgb`: the luminance, in each slice at least 1/1000 of the slice's
/// maximum, so that every direction can be sampled. A slice of zeros becomes 1: loaders divide by the integral of a
/// slice and would get NaN.
SliceStack<float> samplingLuminance(const SliceStack<glm::vec3>& rgb);

}  // namespace gonio
