// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/math/image.h"

namespace gonio::metrics {

/// A metric of two pictures beside SNR and PSNR (image_metrics.h).
struct ImageMetricRecord {
  std::string_view id;       ///< in JSON and in Python
  std::string_view name;     ///< for people
  std::string_view domain;   ///< which values of the pictures it compares
  std::string_view formula;  ///< r and t are the values of reference and test, <> the mean over pixels and channels
  std::string_view reference;
  /// Of linear pictures of one size. @throws Error when the sizes differ.
  double (*compute)(const Image& reference, const Image& test);
  bool higherIsBetter = false;  ///< else 0 is best
};

/// In the order in which they are listed everywhere.
std::span<const ImageMetricRecord> imageMetricRecords();

/// All of them, in the order of imageMetricRecords(). The noise of the pictures counts, unlike in the SNR of
/// PicturePair. @throws Error when the sizes differ.
std::vector<double> imageErrors(const Image& reference, const Image& test);

}  // namespace gonio::metrics
