// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/tabulated_normals.h"

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

constexpr double firstEdge = 1e-5;

/// The edges of the rings: 1 - cos theta, in which a ring's area is even.
template <std::size_t count>
std::array<double, count> makeEdges() {
  std::array<double, count> edges{};
  for (std::size_t i = 1; i < count; ++i) {
    const double theta = firstEdge * std::pow(halfPi / firstEdge, double(i - 1) / double(count - 2));
    edges[i] = 2 * std::sin(theta / 2) * std::sin(theta / 2);
  }
  edges[count - 1] = 1;
  return edges;
}

template <std::size_t count>
const std::array<double, count>& edgesOf(const std::array<double, count>&) {
  static const std::array<double, count> edges = makeEdges<count>();
  return edges;
}

}  // namespace

TabulatedNormals::TabulatedNormals(const std::function<double(double)>& weight) {
  const auto& edges = edgesOf(cumulative_);
  const auto share = [&](int ring, bool cosine) {
    const double low = edges[std::size_t(ring)], high = edges[std::size_t(ring) + 1], middle = (low + high) / 2;
    const double value = cosine ? 1 - middle : weight(2 * std::asin(std::sqrt(middle / 2)));
    return std::isfinite(value) ? std::max(0.0, value) * (high - low) : 0;
  };
  for (const bool cosine : {false, true}) {
    cumulative_[0] = 0;
    for (int ring = 0; ring < rings; ++ring)
      cumulative_[std::size_t(ring) + 1] = cumulative_[std::size_t(ring)] + share(ring, cosine);
    if (cumulative_.back() > 0 && std::isfinite(cumulative_.back())) break;
  }
  const double total = cumulative_.back();
  for (double& value : cumulative_) value /= total;
}

Direction TabulatedNormals::sample(const glm::dvec2& u) const {
  const auto& edges = edgesOf(cumulative_);
  const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, u.x);
  const std::size_t ring = std::size_t(above - cumulative_.begin()) - 1;
  const double share = cumulative_[ring + 1] - cumulative_[ring];
  const double part = share > 0 ? std::min(1.0, (u.x - cumulative_[ring]) / share) : 0.5;
  const double oneMinusCos = edges[ring] + part * (edges[ring + 1] - edges[ring]);
  const double sine = std::sqrt(oneMinusCos * (2 - oneMinusCos)), phi = 2 * pi * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), 1 - oneMinusCos};
}

double TabulatedNormals::density(const Direction& h) const {
  const auto& edges = edgesOf(cumulative_);
  const double oneMinusCos = (h.x * h.x + h.y * h.y) / (1 + std::max(0.0, h.z));
  const auto above = std::upper_bound(edges.begin(), edges.end() - 1, oneMinusCos);
  const std::size_t ring = std::size_t(above - edges.begin()) - 1;
  return (cumulative_[ring + 1] - cumulative_[ring]) / (2 * pi * (edges[ring + 1] - edges[ring]));
}

}  // namespace gonio
