// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "core/math/image.h"

namespace gonio::metrics {

/// 10 log10(signal / noise) of two energies, dB. +infinity without noise; NaN without signal, with or without noise.
inline double decibels(double signal, double noise) {
  if (!(signal > 0)) return std::numeric_limits<double>::quiet_NaN();
  if (noise == 0) return std::numeric_limits<double>::infinity();
  return 10 * std::log10(signal / noise);
}

/// One picture rendered twice: equal expectation, independent noise.
using PicturePair = std::array<Image, 2>;

/// Rendered SNR in dB: 10 log10(|reference|^2 / |reference - test|^2) over all pixels and channels of linear pictures.
/// Equal pictures give +infinity, a black reference NaN (undefined). @throws Error if the sizes differ.
double signalToNoiseRatio(const Image& reference, const Image& test);

/// PSNR, dB, with the largest channel value of the reference as peak. Special cases and errors as signalToNoiseRatio().
double peakSignalToNoiseRatio(const Image& reference, const Image& test);

/// Rendered SNR and PSNR without the noise of the pictures, as for infinitely many samples. Per pixel, the differences
/// d0 and d1 of the two renderings have independent noise, so the sum of d0 . d1 is an unbiased estimate of the error's
/// energy, while the squared difference of the means would include noise. If the estimate is smaller than its own
/// standard error, the square root of the sum of (d0 . d1)^2, the standard error is used instead; then the SNR is a
/// lower bound. If all products are 0 but the pictures differ, the means are compared. If the two pictures of each pair
/// are equal, the results are those of the functions above. Special cases and errors are the same as for those
/// functions.
double signalToNoiseRatio(const PicturePair& reference, const PicturePair& test);
double peakSignalToNoiseRatio(const PicturePair& reference, const PicturePair& test);

/// MSE of linear pictures: the mean of (reference - test)^2 over all pixels and channels, in squared radiance.
/// @throws Error if the sizes differ.
double meanSquaredError(const Image& reference, const Image& test);

/// Root mean square of the difference of linear pictures over that of the reference; 0 for a black reference. Only for
/// pictures of the same size.
double relativeDifference(const Image& reference, const Image& test);

/// The mean of (ln(1 + reference) - ln(1 + test))^2 over all pixels and channels of linear pictures; negative radiance
/// counts as 0. @throws Error if the sizes differ.
double meanSquaredLogError(const Image& reference, const Image& test);

/// The mean of (reference - test)^2 / (reference^2 + 0.01) over all pixels and channels of linear pictures: dark and
/// bright regions have similar weight. After Rousselle, Knaus and Zwicker 2011, "Adaptive Sampling and Reconstruction
/// using Greedy Error Minimization"; papers differ in the offset, here 0.01. @throws Error if the sizes differ.
double relativeMeanSquaredError(const Image& reference, const Image& test);

/// @throws Error if the sizes differ.
void checkEqualSizes(const Image& reference, const Image& test);

}  // namespace gonio::metrics
