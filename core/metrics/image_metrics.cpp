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

void checkSizes(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw Error("pictures of different sizes cannot be compared: " + std::to_string(reference.width) + " x " +
                std::to_string(reference.height) + " and " + std::to_string(test.width) + " x " +
                std::to_string(test.height));
}

Energies energies(const Image& reference, const Image& test) {
  checkSizes(reference, test);
  Energies sums;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const Rgb r(reference.pixels[i]), difference = r - Rgb(test.pixels[i]);
    sums.signal += glm::dot(r, r);
    sums.noise += glm::dot(difference, difference);
    sums.peak = std::max(sums.peak, maxChannel(r));
  }
  return sums;
}

Energies energies(const PicturePair& reference, const PicturePair& test) {
  checkSizes(reference[0], reference[1]);
  checkSizes(reference[0], test[0]);
  checkSizes(reference[1], test[1]);
  Energies sums;
  double squares = 0, ofMeans = 0;
  for (std::size_t i = 0; i < reference[0].pixels.size(); ++i) {
    const Rgb r0(reference[0].pixels[i]), r1(reference[1].pixels[i]);
    const Rgb d0 = r0 - Rgb(test[0].pixels[i]), d1 = r1 - Rgb(test[1].pixels[i]), ofMean = 0.5 * (d0 + d1);
    const double product = glm::dot(d0, d1);
    sums.signal += glm::dot(r0, r1);
    sums.noise += product;
    squares += product * product;
    ofMeans += glm::dot(ofMean, ofMean);
    sums.peak = std::max(sums.peak, maxChannel(0.5 * (r0 + r1)));
  }
  sums.noise = std::max(sums.noise, std::sqrt(squares));
  if (sums.noise == 0) sums.noise = ofMeans;  // roundings here and there: not equal
  return sums;
}

double peakRatio(const Energies& sums, const Image& picture) {
  return decibels(sums.peak * sums.peak * 3 * double(picture.pixels.size()), sums.noise);
}

}  // namespace

double signalToNoiseRatio(const Image& reference, const Image& test) {
  const Energies sums = energies(reference, test);
  return decibels(sums.signal, sums.noise);
}

double signalToNoiseRatio(const PicturePair& reference, const PicturePair& test) {
  const Energies sums = energies(reference, test);
  return decibels(sums.signal, sums.noise);
}

double peakSignalToNoiseRatio(const Image& reference, const Image& test) {
  return peakRatio(energies(reference, test), reference);
}

double peakSignalToNoiseRatio(const PicturePair& reference, const PicturePair& test) {
  return peakRatio(energies(reference, test), reference[0]);
}

}  // namespace gonio::metrics
