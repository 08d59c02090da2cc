// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <vector>

#include "core/math/types.h"

namespace gonio {

/// A linear RGB image in float, row-major, top row first. `alpha` is empty or has one value per pixel (0 background, 1
/// covered); colours are then premultiplied by it, as in OpenEXR.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;
  std::vector<float> alpha;

  Image() = default;
  Image(int imageWidth, int imageHeight)
      : width(imageWidth), height(imageHeight), pixels(std::size_t(imageWidth) * std::size_t(imageHeight)) {}

  std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
  glm::vec3& at(int x, int y) { return pixels[index(x, y)]; }
  const glm::vec3& at(int x, int y) const { return pixels[index(x, y)]; }
};

}  // namespace gonio
