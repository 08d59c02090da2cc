// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/image.h"

namespace gonio::metrics {

/// Rendered SNR in dB: 10 log10(|reference|^2 / |reference - test|^2) over all pixels and channels of linear pictures.
/// Equal pictures give +infinity, a black reference NaN (0/0 and x/0 alike): undefined, not a number to compare.
/// @throws Error when the sizes differ.
double signalToNoiseRatio(const Image& reference, const Image& test);

/// PSNR in dB with the largest channel value of the reference as the peak. Contract as signalToNoiseRatio.
double peakSignalToNoiseRatio(const Image& reference, const Image& test);

}  // namespace gonio::metrics
