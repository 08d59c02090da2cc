// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/image.h"

namespace gonio::metrics {

/// Pixels per degree of visual angle in FLIP: a monitor of 3840 pixels and 0.7 m width at a distance of 0.7 m.
inline constexpr double flipPixelsPerDegree = 0.7 * (3840 / 0.7) * (pi / 180);

/// Mean LDR FLIP over all pixels, in [0, 1]; 0 for equal pictures: the difference that a viewer perceives when the two
/// pictures alternate. Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference
/// Evaluator for Alternating Images", DOI 10.1145/3406183; constants as in the paper and the authors' program (b of the
/// spatial filters: 0.0047 achromatic, 0.0053 red-green, 0.04 and 0.025 for the two Gaussians of blue-yellow). Compares
/// the displayed pictures, clamped to [0, 1].
/// @throws Error if the sizes differ.
double flip(const Image& reference, const Image& test);

}  // namespace gonio::metrics
