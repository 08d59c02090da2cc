// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/evaluation_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace gonio::app {

namespace {

constexpr int timedPairs = 4096, timedRuns = 3;

/// Directions spread over both hemispheres.
std::vector<DirectionPair> spreadPairs() {
  std::vector<DirectionPair> pairs;
  for (int i = 0; i < timedPairs; ++i) {
    const auto share = [i](double step) { return std::fmod(0.5 + i * step, 1.0); };
    pairs.push_back({fromSpherical(share(0.7548776662) * 1.5, 0),
                     fromSpherical(share(0.5698402910) * 1.5, share(0.4301597090) * 2 * pi)});
  }
  return pairs;
}

}  // namespace

double evaluationNanoseconds(const Brdf& brdf) {
  using Clock = std::chrono::steady_clock;
  static const std::vector<DirectionPair> pairs = spreadPairs();
  std::vector<Rgb> values(pairs.size());
  double best = 1e300;
  for (int run = 0; run < timedRuns; ++run) {
    const auto start = Clock::now();
    brdf.evaluate(pairs, values);
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
  }
  return best / timedPairs;
}

}  // namespace gonio::app
