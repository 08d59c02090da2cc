// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/image.h"

namespace gonio::metrics {

/// CIEDE2000 difference of two colours (L*, a*, b*), with the parametric factors kL = kC = kH = 1. Sharma, Wu and Dalal
/// 2005, "The CIEDE2000 Color-Difference Formula: Implementation Notes, Supplementary Test Data, and Mathematical
/// Observations", eq. 2-22, DOI 10.1002/col.20070. About 1 is just noticeable.
double ciede2000(const glm::dvec3& labA, const glm::dvec3& labB);

/// Mean CIEDE2000 over all pixels of the displayed pictures: radiance clamped to [0, 1], linear sRGB converted to
/// CIELAB with D65 white. @throws Error if the sizes differ.
double meanColourDifference(const Image& reference, const Image& test);

}  // namespace gonio::metrics
