// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/error_maps.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/math/round_number.h"
#include "core/math/types.h"
#include "core/rendering/false_colour.h"

namespace gonio {

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

ErrorMaps errorMaps(const Image& reference, std::span<const Image> pictures) {
  ErrorMaps result{.range = errorRange(reference, pictures)};
  for (const Image& picture : pictures) result.maps.push_back(errorMap(reference, picture, result.range));
  return result;
}

}  // namespace gonio
