// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/highlight_hue.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gonio {
namespace {

/// a* and b* of linear sRGB, white at luminance `white`.
glm::dvec2 chromaOf(const Rgb& colour, double white) {
  const Rgb c = glm::max(colour, Rgb(0)) / white;
  const double x = (0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z) / 0.9505, y = luminance(c),
               z = (0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z) / 1.089;
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  return {500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

}  // namespace

double highlightHueError(const Image& reference, const Image& picture) {
  std::vector<std::size_t> shown;
  const auto light = [&](std::size_t i) { return luminance(Rgb(reference.pixels[i])); };
  for (std::size_t i = 0; i < reference.pixels.size(); ++i)
    if ((reference.alpha.empty() || reference.alpha[i] > 0.5f) && light(i) > 0) shown.push_back(i);
  if (shown.empty()) return 0;
  std::ranges::sort(shown, std::greater{}, light);
  const double white = light(shown.front());
  shown.resize(std::max<std::size_t>(1, shown.size() / 20));
  double sum = 0;
  for (const std::size_t i : shown) {
    const glm::dvec2 a = chromaOf(Rgb(reference.pixels[i]), white), b = chromaOf(Rgb(picture.pixels[i]), white);
    // Delta H = 2 sqrt(C1 C2) |sin(Delta h / 2)|.
    sum += std::sqrt(std::max(0.0, 2 * (glm::length(a) * glm::length(b) - glm::dot(a, b))));
  }
  return sum / double(shown.size());
}

}  // namespace gonio
