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

}  // namespace gonio::metrics
