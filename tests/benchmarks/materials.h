// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <random>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/models/registry.h"

namespace gonio::benchmarks {

inline std::unique_ptr<const Brdf> plastic() {
  return models::ggx().instantiate(models::defaultParameters(models::ggx().spec()));
}

inline std::shared_ptr<const TabulatedBrdf> plasticTable() {
  static const auto table = bakeTable(*plastic());
  return table;
}

/// Both directions spread evenly over the hemisphere.
inline std::vector<DirectionPair> randomPairs(std::size_t count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto direction = [&] { return fromSpherical(std::acos(uniform(random)), 2 * pi * uniform(random)); };
  std::vector<DirectionPair> pairs(count);
  for (DirectionPair& pair : pairs) pair = {direction(), direction()};
  return pairs;
}

/// One pixel column after the other of a sphere under one light: neighbours read neighbouring cells.
inline std::vector<DirectionPair> spherePairs(int perAxis) {
  std::vector<DirectionPair> pairs;
  const Direction light = glm::normalize(Direction{0.4, 0.4, 0.82});
  for (int i = 0; i < perAxis * perAxis; ++i) {
    const double x = 2 * (i / perAxis + 0.5) / perAxis - 1, y = 2 * (i % perAxis + 0.5) / perAxis - 1;
    if (x * x + y * y >= 1) continue;
    const Direction n{x, y, std::sqrt(1 - x * x - y * y)};
    const Direction t = glm::normalize(Direction{n.z, 0, -n.x}), b = glm::cross(n, t);
    const auto local = [&](const Direction& w) { return Direction{glm::dot(w, t), glm::dot(w, b), glm::dot(w, n)}; };
    if (glm::dot(light, n) > 0) pairs.push_back({local(light), local({0, 0, 1})});
  }
  return pairs;
}

}  // namespace gonio::benchmarks
