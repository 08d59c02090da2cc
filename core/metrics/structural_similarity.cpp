// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/structural_similarity.h"

#include <limits>

#include "core/math/srgb.h"
#include "core/metrics/image_metrics.h"
#include "core/metrics/plane_filter.h"

namespace gonio::metrics {

namespace {

Plane encodedLuminance(const Image& image) {
  return planeOf(image, [](const Rgb& radiance) { return toSrgb(luminance(displayed(radiance))); });
}

Plane windowMean(const Plane& plane) {
  const std::vector<double> window = gaussianKernel(similarityWindow / 2, 1.5);
  return filtered(plane, window, window);
}

Plane product(const Plane& a, const Plane& b) {
  Plane result = a;
  for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] *= b.values[i];
  return result;
}

}  // namespace

double structuralSimilarity(const Image& reference, const Image& test) {
  checkEqualSizes(reference, test);
  constexpr int margin = similarityWindow / 2;
  if (reference.width < similarityWindow || reference.height < similarityWindow)
    return std::numeric_limits<double>::quiet_NaN();
  const Plane x = encodedLuminance(reference), y = encodedLuminance(test);
  const Plane meanX = windowMean(x), meanY = windowMean(y), squareX = windowMean(product(x, x)),
              squareY = windowMean(product(y, y)), productXy = windowMean(product(x, y));
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  double sum = 0;
  for (int row = margin; row < x.height - margin; ++row)
    for (int column = margin; column < x.width - margin; ++column) {
      const std::size_t i = reference.index(column, row);
      const double mx = meanX.values[i], my = meanY.values[i];
      const double varianceX = squareX.values[i] - mx * mx, varianceY = squareY.values[i] - my * my,
                   covariance = productXy.values[i] - mx * my;
      sum += (2 * mx * my + c1) * (2 * covariance + c2) / ((mx * mx + my * my + c1) * (varianceX + varianceY + c2));
    }
  return sum / (double(x.width - 2 * margin) * double(x.height - 2 * margin));
}

}  // namespace gonio::metrics
