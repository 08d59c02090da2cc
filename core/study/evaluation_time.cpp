// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/evaluation_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <random>

namespace gonio::study {

namespace {

constexpr std::size_t pairCount = 1 << 14;
constexpr std::size_t maxRuns = 7, minRuns = 3;
constexpr double enoughTimedSeconds = 0.5;

std::vector<DirectionPair> randomPairs() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto direction = [&] {
    const double cosine = 1 - uniform(random);  // in (0, 1]: above the horizon
    return fromSpherical(std::acos(cosine), 2 * pi * uniform(random));
  };
  std::vector<DirectionPair> pairs(pairCount);
  for (DirectionPair& pair : pairs) {
    pair.wi = direction();
    pair.wo = direction();
  }
  return pairs;
}

/// Of the processor for this thread, so that other work on the machine does not count; where the system does not report
/// it it, of the clock on the wall.
double threadSeconds() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec time{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0) return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
#endif
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(values);
  const double at = fraction * double(values.size() - 1);
  const auto below = std::size_t(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  // Two equal values, of which one may be infinite, need no arithmetic.
  if (values[below] == values[above] || at == double(below)) return values[below];
  return std::lerp(values[below], values[above], at - double(below));
}

EvaluationTime measureEvaluation(const Brdf& brdf, const TaskControl& control) {
  static const std::vector<DirectionPair> pairs = randomPairs();
  std::vector<Rgb> values(pairs.size());
  std::vector<double> runs;
  double total = 0;
  while (runs.size() < minRuns || (runs.size() < maxRuns && total < enoughTimedSeconds)) {
    control.throwIfStopped();
    const double start = threadSeconds();
    brdf.evaluate(pairs, values);
    const double seconds = threadSeconds() - start;
    runs.push_back(seconds * 1e9 / double(pairCount));
    total += seconds;
  }
  return {quantile(runs, 0.5), quantile(runs, 0.25), quantile(runs, 0.75)};
}

}  // namespace gonio::study
