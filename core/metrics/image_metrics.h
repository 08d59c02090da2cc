// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>

#include "core/math/image.h"

namespace gonio::metrics {

/// One picture rendered twice: the same expectation, noise that is independent of each other.
using PicturePair = std::array<Image, 2>;

/// Rendered SNR in dB: 10 log10(|reference|^2 / |reference - test|^2) over all pixels and channels of linear pictures.
/// Equal pictures give +infinity, a black reference NaN (0/0 and x/0 alike): undefined, not a number to compare.
/// @throws Error when the sizes differ.
double signalToNoiseRatio(const Image& reference, const Image& test);

/// PSNR in dB with the largest channel value of the reference as the peak. Contract as signalToNoiseRatio.
double peakSignalToNoiseRatio(const Image& reference, const Image& test);

/// Rendered SNR and PSNR of the pictures that infinitely many samples would show. In each pixel the differences d0 and
/// d1 of the two renderings err independently, so the sum of their products estimates the energy of the error without
/// bias, where the squared difference of their means also counts the noise that reference and test do not share. The
/// estimate is held at its own standard error, the root of the sum of (d0 . d1)^2: below it nothing is known, and the
/// SNR is a lower bound. Where all products are 0 and the pictures are not equal, it is that of the means. Pairs of
/// equal halves give what the plain functions give; contract as theirs.
double signalToNoiseRatio(const PicturePair& reference, const PicturePair& test);
double peakSignalToNoiseRatio(const PicturePair& reference, const PicturePair& test);

/// MSE of linear pictures: the mean of (reference - test)^2 over all pixels and channels, in squared radiance.
/// @throws Error when the sizes differ.
double meanSquaredError(const Image& reference, const Image& test);

/// The mean of (ln(1 + reference) - ln(1 + test))^2 over all pixels and channels of linear pictures; negative radiance
/// counts as 0. @throws Error when the sizes differ.
double meanSquaredLogError(const Image& reference, const Image& test);

/// The mean of (reference - test)^2 / (reference^2 + 0.01) over all pixels and channels of linear pictures: errors of
/// dark regions count as those of bright ones. After Rousselle, Knaus and Zwicker 2011, "Adaptive Sampling and
/// Reconstruction using Greedy Error Minimization"; papers differ in the offset, here 0.01. @throws Error when the
/// sizes differ.
double relativeMeanSquaredError(const Image& reference, const Image& test);

/// @throws Error when the sizes differ.
void checkEqualSizes(const Image& reference, const Image& test);

}  // namespace gonio::metrics
