// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/error_maps.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "core/math/round_number.h"
#include "core/math/types.h"

namespace gonio::rendering {

namespace {

/// Linear between anchors that are spaced evenly over [0, 1].
DisplayColour between(std::span<const DisplayColour> anchors, double x) {
  const double at = (x > 0 ? std::min(x, 1.0) : 0.0) * double(anchors.size() - 1);
  const std::size_t low = std::min(std::size_t(at), anchors.size() - 2);
  DisplayColour colour;
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] =
        std::uint8_t(std::lround(anchors[low][c] + (at - double(low)) * (anchors[low + 1][c] - anchors[low][c])));
  return colour;
}

}  // namespace

DisplayColour viridis(double x) {
  constexpr DisplayColour anchors[] = {{68, 1, 84},    {72, 40, 120},  {62, 73, 137},  {49, 104, 142}, {38, 130, 142},
                                       {31, 158, 137}, {53, 183, 121}, {110, 206, 88}, {181, 222, 43}, {253, 231, 37}};
  return between(anchors, x);
}

DisplayColour signedColour(double x) {
  constexpr DisplayColour anchors[] = {{196, 232, 255}, {66, 150, 230}, {18, 18, 20}, {226, 120, 40}, {255, 226, 180}};
  return between(anchors, 0.5 + 0.5 * x);
}

namespace {

bool isCovered(const Image& image, std::size_t i) { return image.alpha.empty() || image.alpha[i] > 0; }

double differenceAt(const Image& reference, const Image& picture, std::size_t i) {
  return std::abs(luminance(Rgb(picture.pixels[i])) - luminance(Rgb(reference.pixels[i])));
}

}  // namespace

double errorRange(const Image& reference, std::span<const Image> pictures) {
  constexpr double percentile = 0.995;
  std::vector<double> differences;
  for (const Image& picture : pictures)
    for (std::size_t i = 0; i < reference.pixels.size(); ++i)
      if (isCovered(reference, i)) differences.push_back(differenceAt(reference, picture, i));
  if (differences.empty()) return 0;
  const auto at = differences.begin() + std::ptrdiff_t(percentile * double(differences.size() - 1));
  std::nth_element(differences.begin(), at, differences.end());
  return roundedUp(*at);
}

std::vector<std::uint8_t> errorMap(const Image& reference, const Image& picture, double range) {
  assert(picture.pixels.size() == reference.pixels.size());
  std::vector<std::uint8_t> map;
  map.reserve(4 * reference.pixels.size());
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const DisplayColour colour = viridis(range > 0 ? differenceAt(reference, picture, i) / range : 0);
    map.insert(map.end(), colour.begin(), colour.end());
    map.push_back(reference.alpha.empty() ? 255 : std::uint8_t(std::lround(255 * reference.alpha[i])));
  }
  return map;
}

}  // namespace gonio::rendering
