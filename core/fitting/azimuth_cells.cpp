// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/azimuth_cells.h"

#include <algorithm>
#include <cmath>

#include "core/math/parallel.h"
#include "core/math/sampling.h"
#include "core/math/types.h"

namespace gonio::fitting {

namespace {

constexpr std::size_t block = 4096;

struct Place {
  DirectionPair pair;
  double measure = 0;
  bool aboveHorizon = false;
};

Place placeIn(const AzimuthStrata& strata, std::size_t stratum) {
  constexpr std::uint32_t thetaSeed = 1, phiSeed = 2;
  std::size_t rest = stratum;
  const auto next = [&rest](int count) {
    const std::size_t index = rest % std::size_t(count);
    rest /= std::size_t(count);
    return double(index);
  };
  const glm::dvec2 theta = scrambledSobol(std::uint32_t(stratum), thetaSeed);
  const glm::dvec2 phi = scrambledSobol(std::uint32_t(stratum), phiSeed);
  const double phiH = (next(strata.phiH) + phi.x) / strata.phiH * 2 * pi;
  const double phiD = (next(strata.phiD) + phi.y) / strata.phiD * pi;
  const double thetaD = (next(strata.thetaD) + theta.x) / strata.thetaD * halfPi;
  const double root = (next(strata.thetaH) + theta.y) / strata.thetaH, thetaH = root * root * halfPi;
  Place place;
  place.aboveHorizon = isAboveHorizon(thetaH, thetaD, phiD);
  place.pair = AzimuthRotation(phiH)(fromHalfDifference(thetaH, thetaD, phiD));
  // d wi d wo = 4 cos theta_d d omega_h d omega_d, and d theta_h is proportional to the root.
  place.measure = 4 * std::cos(thetaD) * std::sin(thetaH) * root * std::sin(thetaD);
  return place;
}

/// The mean over both orders; `measured`: whether either was.
void evaluateBothOrders(const Brdf& brdf, std::span<const Place> places, std::span<Rgb> values,
                        std::span<std::uint8_t> measured) {
  std::vector<DirectionPair> pairs;
  for (const Place& place : places) pairs.push_back(place.pair);
  brdf.evaluate(pairs, values);
  std::vector<DirectionPair> exchanged;
  for (const DirectionPair& pair : pairs) exchanged.push_back({pair.wo, pair.wi});
  std::vector<Rgb> others(values.begin(), values.end());
  if (!brdf.isReciprocal()) brdf.evaluate(exchanged, others);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const bool first = brdf.hasData(pairs[i]), second = brdf.hasData(exchanged[i]);
    measured[i] = first || second;
    if (first && second)
      values[i] = 0.5 * (values[i] + others[i]);
    else if (second)
      values[i] = others[i];
  }
}

}  // namespace

FitCells azimuthCells(const Brdf& brdf, double maxPolarAngle, const AzimuthStrata& strata, AzimuthCellCounts& counts) {
  const std::size_t count =
      std::size_t(strata.thetaH) * std::size_t(strata.thetaD) * std::size_t(strata.phiD) * std::size_t(strata.phiH);
  std::vector<Place> places(count);
  std::vector<Rgb> values(count);
  std::vector<std::uint8_t> measured(count);
  parallelForBlocks(count, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) places[i] = placeIn(strata, i);
    evaluateBothOrders(brdf, std::span(places).subspan(begin, end - begin),
                       std::span(values).subspan(begin, end - begin), std::span(measured).subspan(begin, end - begin));
  });
  const double minCosine = std::cos(maxPolarAngle);
  counts = {};
  FitCells cells;
  cells.symmetry = DataSymmetry::anisotropic;
  for (std::size_t i = 0; i < count; ++i) {
    if (!places[i].aboveHorizon || !measured[i]) {
      ++counts.invalid;
    } else if (std::min(places[i].pair.wi.z, places[i].pair.wo.z) < minCosine) {
      ++counts.grazing;
    } else {
      ++counts.used;
      for (int channel = 0; channel < 3; ++channel) counts.negative += values[i][channel] < 0;
      cells.append(places[i].pair, glm::max(values[i], Rgb(0)), places[i].measure);
    }
  }
  cells.normaliseWeights();
  return cells;
}

}  // namespace gonio::fitting
