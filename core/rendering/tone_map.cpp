// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/tone_map.h"

#include <algorithm>
#include <cmath>

#include "core/math/parallel.h"

namespace gonio::rendering {

namespace {

/// NaN becomes 0: a picture for people has no undefined pixels.
double saturate(double x) { return x > 0 ? std::min(x, 1.0) : 0.0; }

double filmicCurve(double x) {
  // Beyond this the curve is at 1 and its quotient could overflow.
  if (x > 1e6) return 1;
  return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

std::uint8_t toByte(double x) { return static_cast<std::uint8_t>(std::lround(255 * saturate(x))); }

}  // namespace

std::string_view toneMapName(ToneMap toneMap) { return toneMap == ToneMap::clamp ? "clamp" : "filmic"; }

Rgb toneMapped(const Rgb& radiance, double exposure, ToneMap toneMap) {
  const Rgb exposed = radiance * std::exp2(exposure);
  Rgb display;
  for (int channel = 0; channel < 3; ++channel) {
    const double x = exposed[channel] > 0 ? exposed[channel] : 0;
    display[channel] = saturate(toneMap == ToneMap::filmic ? filmicCurve(x) : x);
  }
  return display;
}

double radianceOf(double display, double exposure, ToneMap toneMap) {
  double x = display;
  if (toneMap == ToneMap::filmic) {
    // The positive root of the curve's equation for x.
    const double a = 2.51 - 2.43 * display, b = 0.03 - 0.59 * display, c = -0.14 * display;
    x = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
  }
  return x * std::exp2(-exposure);
}

std::vector<std::uint8_t> toDisplayBytes(const Image& image, double exposure, ToneMap toneMap) {
  constexpr std::size_t block = 4096;
  std::vector<std::uint8_t> bytes(image.pixels.size() * 4);
  parallelForBlocks(image.pixels.size(), block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double alpha = image.alpha.empty() ? 1.0 : saturate(image.alpha[i]);
      const Rgb straight = alpha > 0 ? Rgb(image.pixels[i]) / alpha : Rgb(0);
      const Rgb display = toneMapped(straight, exposure, toneMap);
      for (int channel = 0; channel < 3; ++channel)
        bytes[4 * i + std::size_t(channel)] = toByte(toSrgb(display[channel]));
      bytes[4 * i + 3] = toByte(alpha);
    }
  });
  return bytes;
}

}  // namespace gonio::rendering
