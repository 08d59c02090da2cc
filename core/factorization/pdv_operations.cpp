// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_operations.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/math/monotone_cubic.h"
#include "core/math/types.h"
#include "core/support/error.h"

namespace gonio::factorization {

namespace {

template <typename PlaceOf>
std::vector<double> readAt(std::span<const double> nodes, std::span<const double> curve, std::size_t count,
                           const PlaceOf& placeOf) {
  const std::vector<double> slopes = monotoneSlopes(nodes, curve);
  std::vector<double> result(count);
  for (std::size_t i = 0; i < count; ++i) result[i] = evaluateMonotoneCubic(nodes, curve, slopes, placeOf(i));
  return result;
}

double largestSize(const std::vector<double>& curve) {
  double largest = 0;
  for (const double value : curve) largest = std::max(largest, std::abs(value));
  return largest;
}

/// The target with a curve of its first term taken from the first of another.
PdvFactors takeCurve(const PdvFactors& target, const PdvFactors& other, FurtherTerms terms,
                     std::vector<double> PdvTerm::*curve, std::vector<double> PdvFactors::*nodes) {
  if (target.transform != other.transform)
    throw Error("the transforms of the factors are " + std::string(dataTransformNames[std::size_t(other.transform)]) +
                " and " + std::string(dataTransformNames[std::size_t(target.transform)]) + "; expected the same");
  PdvFactors result = terms == FurtherTerms::preserve ? target : target.truncated(1);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::vector<double>& taken = other.channels[channel][0].*curve;
    result.channels[channel][0].*curve =
        other.*nodes == target.*nodes ? taken : resampled(other.*nodes, taken, target.*nodes);
  }
  return withRoomForEdits(result);
}

}  // namespace

std::vector<double> resampled(std::span<const double> nodes, std::span<const double> curve,
                              std::span<const double> newNodes) {
  return readAt(nodes, curve, newNodes.size(), [&](std::size_t i) { return newNodes[i]; });
}

std::vector<double> widened(std::span<const double> nodes, std::span<const double> curve, double factor) {
  return readAt(nodes, curve, nodes.size(), [&](std::size_t i) { return nodes[i] / factor; });
}

std::vector<double> scaled(std::span<const double> curve, double factor) {
  std::vector<double> result(curve.begin(), curve.end());
  for (double& value : result) value *= factor;
  return result;
}

std::vector<double> tilted(std::span<const double> nodes, std::span<const double> curve, double amount) {
  std::vector<double> result(curve.begin(), curve.end());
  const double range = nodes.back() - nodes.front();
  for (std::size_t i = 0; i < result.size() && range > 0; ++i)
    result[i] *= 1 + amount * (2 * (nodes[i] - nodes.front()) / range - 1);
  return result;
}

std::vector<double> smoothed(std::span<const double> curve, double radius) {
  constexpr double cut = 3;
  std::vector<double> result(curve.begin(), curve.end());
  if (!(radius > 0)) return result;
  const auto count = std::ptrdiff_t(curve.size());
  const auto reach = std::ptrdiff_t(std::min(std::ceil(cut * radius), double(count)));
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    double sum = 0, weights = 0;
    for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, i - reach); j < std::min(count, i + reach + 1); ++j) {
      const double distance = double(j - i) / radius, weight = std::exp(-distance * distance / 2);
      sum += weight * curve[std::size_t(j)];
      weights += weight;
    }
    result[std::size_t(i)] = sum / weights;
  }
  return result;
}

PdvFactors withF1Of(const PdvFactors& target, const PdvFactors& other, FurtherTerms terms) {
  return takeCurve(target, other, terms, &PdvTerm::f1, &PdvFactors::thetaNodes);
}

PdvFactors withF2Of(const PdvFactors& target, const PdvFactors& other, FurtherTerms terms) {
  return takeCurve(target, other, terms, &PdvTerm::f2, &PdvFactors::deviationNodes);
}

PdvFactors widenF2(const PdvFactors& target, double factor) {
  if (!(factor > 0) || !std::isfinite(factor))
    throw Error("the width scale of F2 is " + std::to_string(factor) + "; expected a positive number");
  PdvFactors result = target;
  for (std::vector<PdvTerm>& channel : result.channels)
    for (PdvTerm& term : channel) term.f2 = widened(target.deviationNodes, term.f2, factor);
  return result;
}

PdvFactors withRoomForEdits(const PdvFactors& factors) {
  PdvFactors result = factors;
  for (const std::vector<PdvTerm>& channel : factors.channels) {
    double reach = 0;
    for (const PdvTerm& term : channel) reach += largestSize(term.f1) * largestSize(term.f2) * largestSize(term.f3);
    result.highest = std::max(result.highest, std::min(reach, maxCurveValue));
  }
  if (factors.highest > 0) result.lowest *= result.highest / factors.highest;
  return result;
}

std::string curveLimitWarning(const PdvFactors& factors) {
  std::size_t count = 0;
  double largest = 0;
  std::string where;
  for (std::size_t c = 0; c < factors.channels.size(); ++c)
    for (std::size_t term = 0; term < factors.channels[c].size(); ++term) {
      const PdvTerm& curves = factors.channels[c][term];
      int number = 0;
      for (const std::vector<double>* curve : {&curves.f1, &curves.f2, &curves.f3}) {
        ++number;
        for (const double value : *curve) count += std::abs(value) > maxCurveValue;
        if (!(largestSize(*curve) > std::max(largest, maxCurveValue))) continue;
        largest = largestSize(*curve);
        where = "F" + std::to_string(number) + " of term " + std::to_string(term + 1) + " in " + channelNames[c];
      }
    }
  if (count == 0) return {};
  char text[200];
  std::snprintf(text, sizeof text, "%zu %s of the factor curves %s larger than %.0e (%.3g in %s) and %s limited to it",
                count, count == 1 ? "value" : "values", count == 1 ? "is" : "are", maxCurveValue, largest,
                where.c_str(), count == 1 ? "is" : "are");
  return text;
}

}  // namespace gonio::factorization
