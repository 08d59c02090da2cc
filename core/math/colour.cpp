// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/colour.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace gonio {

double toSrgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double fromSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Rgb displayed(const Rgb& radiance) {
  const auto clamped = [](double x) { return x > 0 ? std::min(x, 1.0) : 0.0; };
  return {clamped(radiance.x), clamped(radiance.y), clamped(radiance.z)};
}

namespace {

/// A bell that falls off differently to either side.
double bell(double x, double centre, double widthBelow, double widthAbove) {
  const double t = (x - centre) / (x < centre ? widthBelow : widthAbove);
  return std::exp(-0.5 * t * t);
}

constexpr double daylightStep = 10;
/// D65 from 380 to 780 nm (ISO 11664-2), in steps of daylightStep.
constexpr double daylightTable[] = {49.9755, 54.6482, 82.7549, 91.486,  93.4318, 86.6823, 104.865, 117.008, 117.812,
                                    114.861, 115.923, 108.811, 109.354, 107.802, 104.79,  107.689, 104.405, 104.046,
                                    100,     96.3342, 95.788,  88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992,
                                    80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.349,  61.604,  69.8856,
                                    75.087,  63.5927, 46.4182, 66.8054, 63.3828};
static_assert(std::size(daylightTable) ==
              std::size_t((maxVisibleWavelength - minVisibleWavelength) / daylightStep) + 1);

}  // namespace

glm::dvec3 colourMatching(double nanometres) {
  const double x = nanometres;
  return {1.056 * bell(x, 599.8, 37.9, 31.0) + 0.362 * bell(x, 442.0, 16.0, 26.7) - 0.065 * bell(x, 501.1, 20.4, 26.2),
          0.821 * bell(x, 568.8, 46.9, 40.5) + 0.286 * bell(x, 530.9, 16.3, 31.1),
          1.217 * bell(x, 437.0, 11.8, 36.0) + 0.681 * bell(x, 459.0, 26.0, 13.8)};
}

double illuminantD65(double nanometres) {
  const double at =
      (std::clamp(nanometres, minVisibleWavelength, maxVisibleWavelength) - minVisibleWavelength) / daylightStep;
  const auto below = std::min(std::size_t(at), std::size(daylightTable) - 2);
  return std::lerp(daylightTable[below], daylightTable[below + 1], at - double(below));
}

Rgb linearSrgb(const glm::dvec3& xyz) {
  return {3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
          0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
}

std::vector<Rgb> spectrumWeights(std::span<const double> nanometres) {
  assert(!nanometres.empty() && std::is_sorted(nanometres.begin(), nanometres.end()));
  std::vector<Rgb> weights(nanometres.size(), Rgb(0));
  Rgb white(0);
  for (int step = 0; step <= int(maxVisibleWavelength - minVisibleWavelength); ++step) {
    const double at = minVisibleWavelength + step;
    const Rgb colour = linearSrgb(illuminantD65(at) * colourMatching(at));
    white += colour;
    const auto above = std::lower_bound(nanometres.begin(), nanometres.end(), at);
    const auto right = std::size_t(std::min(above, nanometres.end() - 1) - nanometres.begin());
    if (above == nanometres.begin() || above == nanometres.end()) {
      weights[right] += colour;
      continue;
    }
    const double fraction = (at - nanometres[right - 1]) / (nanometres[right] - nanometres[right - 1]);
    weights[right - 1] += (1 - fraction) * colour;
    weights[right] += fraction * colour;
  }
  for (Rgb& weight : weights) weight /= white;
  return weights;
}

}  // namespace gonio
