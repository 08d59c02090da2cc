// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/math/image.h"

namespace gonio::metrics {

/// One number per pixel of a picture, row-major.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<double> values;
};

/// function(pixel) for every pixel, with the radiance as double.
template <typename Function>
Plane planeOf(const Image& image, const Function& function) {
  Plane plane{.width = image.width, .height = image.height, .values = std::vector<double>(image.pixels.size())};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) plane.values[i] = function(Rgb(image.pixels[i]));
  return plane;
}

/// Correlation with the separable kernel column(y) row(x); pixels beyond the border have the value of the nearest
/// pixel. Parallel; results do not depend on the number of threads. @param row, column weights of an odd number of
/// pixels, centred at the pixel.
Plane filtered(const Plane& plane, std::span<const double> row, std::span<const double> column);

/// exp(-x^2 / (2 deviation^2)) for x = -radius, .., radius, divided by its sum. @param deviation standard deviation in
/// pixels, > 0.
std::vector<double> gaussianKernel(int radius, double deviation);

}  // namespace gonio::metrics
