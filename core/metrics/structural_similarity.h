// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/image.h"

namespace gonio::metrics {

/// Side of the SSIM window in pixels.
inline constexpr int similarityWindow = 11;

/// Mean SSIM, in [-1, 1]; 1 for equal pictures. Wang, Bovik, Sheikh and Simoncelli 2004, "Image Quality Assessment:
/// From Error Visibility to Structural Similarity", eq. 13-17, DOI 10.1109/TIP.2003.819861: a Gaussian window of 11 x
/// 11 pixels with a standard deviation of 1.5 pixels, K1 = 0.01, K2 = 0.03, over the windows inside the picture.
/// Compares the luminance of the displayed pictures, clamped to [0, 1] and encoded as sRGB (dynamic range L = 1). NaN
/// (undefined) for pictures smaller than the window. @throws Error if the sizes differ.
double structuralSimilarity(const Image& reference, const Image& test);

}  // namespace gonio::metrics
