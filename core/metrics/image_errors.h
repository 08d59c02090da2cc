// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/math/image.h"

namespace gonio::metrics {

/// A metric of two pictures other than SNR and PSNR (image_metrics.h).
struct ImageMetricRecord {
  std::string_view id;       ///< in JSON and in Python
  std::string_view name;     ///< for display
  std::string_view domain;   ///< the values of the pictures that it compares
  std::string_view formula;  ///< in ASCII; means are over pixels and channels
  std::string_view reference;
  /// Computes the metric of linear pictures. @throws Error if the sizes differ.
  double (*compute)(const Image& reference, const Image& test);
  bool higherIsBetter = false;  ///< false: 0 is best
};

/// All metrics, in the order of display.
std::span<const ImageMetricRecord> imageMetricRecords();

/// All metrics, in the order of imageMetricRecords(). They include the noise of the pictures, unlike the SNR of a
/// PicturePair. @throws Error if the sizes differ.
std::vector<double> imageErrors(const Image& reference, const Image& test);

/// CIEDE2000 difference of two colours (L*, a*, b*), with the parametric factors kL = kC = kH = 1. Sharma, Wu and Dalal
/// 2005, "The CIEDE2000 Color-Difference Formula: Implementation Notes, Supplementary Test Data, and Mathematical
/// Observations", eq. 2-22, DOI 10.1002/col.20070. About 1 is just noticeable.
double ciede2000(const glm::dvec3& labA, const glm::dvec3& labB);

/// Mean CIEDE2000 over all pixels of the displayed pictures: radiance clamped to [0, 1], linear sRGB converted to
/// CIELAB with D65 white. @throws Error if the sizes differ.
double meanColourDifference(const Image& reference, const Image& test);

/// Pixels per degree of visual angle in FLIP: a monitor of 3840 pixels and 0.7 m width at a distance of 0.7 m.
inline constexpr double flipPixelsPerDegree = 0.7 * (3840 / 0.7) * (pi / 180);

/// Mean LDR FLIP over all pixels, in [0, 1]; 0 for equal pictures: the difference that a viewer perceives when the two
/// pictures alternate. Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference
/// Evaluator for Alternating Images", DOI 10.1145/3406183; constants as in the paper and the authors' program (b of the
/// spatial filters: 0.0047 achromatic, 0.0053 red-green, 0.04 and 0.025 for the two Gaussians of blue-yellow). Compares
/// the displayed pictures, clamped to [0, 1].
/// @throws Error if the sizes differ.
double flip(const Image& reference, const Image& test);

/// Side of the SSIM window in pixels.
inline constexpr int similarityWindow = 11;

/// Mean SSIM, in [-1, 1]; 1 for equal pictures. Wang, Bovik, Sheikh and Simoncelli 2004, "Image Quality Assessment:
/// From Error Visibility to Structural Similarity", eq. 13-17, DOI 10.1109/TIP.2003.819861: a Gaussian window of 11 x
/// 11 pixels with a standard deviation of 1.5 pixels, K1 = 0.01, K2 = 0.03, over the windows inside the picture.
/// Compares the luminance of the displayed pictures, clamped to [0, 1] and encoded as sRGB (dynamic range L = 1). NaN
/// (undefined) for pictures smaller than the window. @throws Error if the sizes differ.
double structuralSimilarity(const Image& reference, const Image& test);

}  // namespace gonio::metrics
