// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/tabulated_normals.h"

#include <algorithm>
#include <cmath>

#include "core/math/linear_ramp.h"

namespace gonio {

namespace {

constexpr double firstCircle = 1e-5;

/// The circles by 1 - cos theta, in which areas are even.
template <std::size_t count>
std::array<double, count> makeCircles() {
  std::array<double, count> circles{};
  for (std::size_t i = 1; i < count; ++i) {
    const double theta = firstCircle * std::pow(halfPi / firstCircle, double(i - 1) / double(count - 2));
    circles[i] = 2 * std::sin(theta / 2) * std::sin(theta / 2);
  }
  circles[count - 1] = 1;
  return circles;
}

template <std::size_t count>
const std::array<double, count>& circlesOf(const std::array<double, count>&) {
  static const std::array<double, count> circles = makeCircles<count>();
  return circles;
}

/// The last circle at or inside of `value`, so that another follows it.
template <std::size_t count>
std::size_t ringOf(const std::array<double, count>& ascending, double value) {
  const auto above = std::upper_bound(ascending.begin() + 1, ascending.end() - 1, value);
  return std::size_t(above - ascending.begin()) - 1;
}

}  // namespace

TabulatedNormals::TabulatedNormals(const std::function<double(double)>& weight) {
  const auto& x = circlesOf(density_);
  for (const bool cosine : {false, true}) {
    for (std::size_t i = 0; i < circles; ++i) {
      const double value = cosine ? 1 - x[i] : weight(2 * std::asin(std::sqrt(x[i] / 2)));
      density_[i] = std::isfinite(value) ? std::max(0.0, value) : 0;
    }
    cumulative_[0] = 0;
    for (std::size_t i = 1; i < circles; ++i)
      cumulative_[i] = cumulative_[i - 1] + pi * (density_[i - 1] + density_[i]) * (x[i] - x[i - 1]);
    if (!cosine) total_ = cumulative_.back();
    if (cumulative_.back() > 0 && std::isfinite(cumulative_.back())) break;
  }
  const double total = cumulative_.back();
  for (double& value : cumulative_) value /= total;
  for (double& value : density_) value /= total;
}

Direction TabulatedNormals::sample(const glm::dvec2& u) const {
  const auto& x = circlesOf(density_);
  const std::size_t ring = ringOf(cumulative_, u.x);
  const double width = x[ring + 1] - x[ring];
  const double area = std::max(0.0, u.x - cumulative_[ring]) / (2 * pi * width);
  const double oneMinusCos = x[ring] + inverseOfRamp(density_[ring], density_[ring + 1], area) * width;
  const double sine = std::sqrt(oneMinusCos * (2 - oneMinusCos)), phi = 2 * pi * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), 1 - oneMinusCos};
}

double TabulatedNormals::density(const Direction& h) const {
  const auto& x = circlesOf(density_);
  const double oneMinusCos = std::min(1.0, (h.x * h.x + h.y * h.y) / (1 + std::max(0.0, h.z)));
  const std::size_t ring = ringOf(x, oneMinusCos);
  const double t = (oneMinusCos - x[ring]) / (x[ring + 1] - x[ring]);
  return density_[ring] + t * (density_[ring + 1] - density_[ring]);
}

}  // namespace gonio
