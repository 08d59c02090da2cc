// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/image_metrics.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/support/error.h"

namespace gonio::metrics {

namespace {

struct Energies {
  double signal = 0, noise = 0, peak = 0;
};

Energies energies(const Image& reference, const Image& test) {
  checkEqualSizes(reference, test);
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
  checkEqualSizes(reference[0], reference[1]);
  checkEqualSizes(reference[0], test[0]);
  checkEqualSizes(reference[1], test[1]);
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

/// The mean of error(reference, test) over all pixels and channels.
template <typename Error>
double channelMean(const Image& reference, const Image& test, Error error) {
  checkEqualSizes(reference, test);
  double sum = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      sum += error(double(reference.pixels[i][channel]), double(test.pixels[i][channel]));
  return sum / (3 * double(reference.pixels.size()));
}

double square(double x) { return x * x; }

}  // namespace

void checkEqualSizes(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw Error("images of different sizes cannot be compared: " + std::to_string(reference.width) + " x " +
                std::to_string(reference.height) + " and " + std::to_string(test.width) + " x " +
                std::to_string(test.height));
}

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

double meanSquaredError(const Image& reference, const Image& test) {
  return channelMean(reference, test, [](double r, double t) { return square(r - t); });
}

double relativeDifference(const Image& reference, const Image& test) {
  double difference = 0, total = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const Rgb x(reference.pixels[i]), d = x - Rgb(test.pixels[i]);
    difference += glm::dot(d, d);
    total += glm::dot(x, x);
  }
  return total > 0 ? std::sqrt(difference / total) : 0;
}

double meanSquaredLogError(const Image& reference, const Image& test) {
  return channelMean(reference, test, [](double r, double t) {
    return square(std::log1p(std::max(r, 0.0)) - std::log1p(std::max(t, 0.0)));
  });
}

double relativeMeanSquaredError(const Image& reference, const Image& test) {
  constexpr double offset = 0.01;
  return channelMean(reference, test, [](double r, double t) { return square(r - t) / (r * r + offset); });
}

}  // namespace gonio::metrics
