// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/rgl_luminance.h"

#include <algorithm>

namespace gonio {

SliceStack<float> samplingLuminance(const SliceStack<glm::vec3>& rgb) {
  constexpr float minFraction = 1e-3f;
  SliceStack<float> result{rgb.width, rgb.height, std::vector<float>(rgb.values.size())};
  std::ranges::transform(rgb.values, result.values.begin(),
                         [](const glm::vec3& value) { return float(luminance(Rgb(value))); });
  const std::size_t plane = rgb.width * rgb.height;
  for (std::size_t start = 0; start < result.values.size(); start += plane) {
    const std::span slice(&result.values[start], plane);
    const float largest = std::ranges::max(slice);
    for (float& value : slice) value = largest > 0 ? std::max(value, minFraction * largest) : 1;
  }
  return result;
}

}  // namespace gonio
