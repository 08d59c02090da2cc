// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/image_metrics.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/metrics/decibels.h"
#include "core/support/error.h"

namespace gonio::metrics {

namespace {

struct Energies {
  double signal = 0, noise = 0, peak = 0;
};

Energies energies(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw Error("pictures of different sizes cannot be compared: " + std::to_string(reference.width) + " x " +
                std::to_string(reference.height) + " and " + std::to_string(test.width) + " x " +
                std::to_string(test.height));
  Energies sums;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const Rgb r(reference.pixels[i]), difference = r - Rgb(test.pixels[i]);
    sums.signal += glm::dot(r, r);
    sums.noise += glm::dot(difference, difference);
    sums.peak = std::max(sums.peak, maxChannel(r));
  }
  return sums;
}

}  // namespace

double signalToNoiseRatio(const Image& reference, const Image& test) {
  const Energies sums = energies(reference, test);
  return decibels(sums.signal, sums.noise);
}

double peakSignalToNoiseRatio(const Image& reference, const Image& test) {
  const Energies sums = energies(reference, test);
  return decibels(sums.peak * sums.peak * 3 * double(reference.pixels.size()), sums.noise);
}

}  // namespace gonio::metrics
