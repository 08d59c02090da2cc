// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_factors.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "core/factorization/deviation_grid.h"
#include "core/factorization/joint_terms.h"
#include "core/factorization/pdv_samples.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

std::vector<double> evenNodes(int count, double last) {
  std::vector<double> nodes;
  nodes.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i) nodes.push_back(last * i / (count - 1));
  return nodes;
}

PdvFactors makeAxes(const TabulatedBrdf& table, const PdvOptions& options, const TaskControl& control) {
  if (options.terms < 1 || options.terms > maxPdvTerms)
    throw Error("the count of terms is " + std::to_string(options.terms) + "; expected 1 to " +
                std::to_string(maxPdvTerms));
  for (const int count : {options.thetaNodes, options.phiNodes})
    if (count < 2 || count > maxPdvNodes)
      throw Error("the count of nodes is " + std::to_string(count) + "; expected 2 to " + std::to_string(maxPdvNodes));
  PdvFactors axes{.form = options.form, .transform = options.transform};
  axes.thetaNodes = evenNodes(options.thetaNodes, maxPolarAngle);
  axes.phiNodes = options.form == PdvForm::twoFactors ? std::vector{0.0} : evenNodes(options.phiNodes, pi);
  axes.deviationNodes = options.deviationNodes;
  if (axes.deviationNodes.empty()) {
    // No owner: the table outlives the call.
    const std::shared_ptr<const TabulatedBrdf> unowned(std::shared_ptr<void>(), &table);
    axes.deviationNodes = deviationNodes(std::span(&unowned, 1), defaultDeviations, control);
  }
  const std::vector<double>& nodes = axes.deviationNodes;
  if (nodes.size() < 2 || nodes.front() != 0 || !std::is_sorted(nodes.begin(), nodes.end(), std::less_equal<>()))
    throw Error("|Dp| needs at least two nodes, strictly increasing from 0");
  return axes;
}

/// Which nodes of a mode hold a cell that counts.
std::vector<bool> measuredNodes(const MaskedTensor& t, int mode) {
  std::vector<bool> measured(std::size_t(t.sizes[mode]), false);
  for (int i = 0; i < t.sizes[0]; ++i)
    for (int j = 0; j < t.sizes[1]; ++j)
      for (int k = 0; k < t.sizes[2]; ++k)
        if (t.weights[t.index(i, j, k)] > 0) measured[std::size_t(mode == 0 ? i : mode == 1 ? j : k)] = true;
  return measured;
}

/// Nodes without a measurement take the value of the nearest that has one, so that curves do not
/// fall to 0 toward them.
void holdUnmeasured(std::vector<double>& curve, const std::vector<bool>& measured) {
  const std::vector<double> known = curve;
  const auto count = std::ptrdiff_t(curve.size());
  for (std::ptrdiff_t i = 0; i < count; ++i)
    for (std::ptrdiff_t distance = 0; distance < count; ++distance) {
      const std::ptrdiff_t before = i - distance, after = i + distance;
      const bool atBefore = before >= 0 && measured[std::size_t(before)];
      if (!atBefore && !(after < count && measured[std::size_t(after)])) continue;
      curve[std::size_t(i)] = known[std::size_t(atBefore ? before : after)];
      break;
    }
}

using MeasuredNodes = std::array<std::vector<bool>, 3>;

PdvTerm heldTerm(RankOne term, const MeasuredNodes& measured) {
  holdUnmeasured(term.a, measured[0]);
  holdUnmeasured(term.b, measured[1]);
  holdUnmeasured(term.c, measured[2]);
  return {std::move(term.a), std::move(term.b), std::move(term.c)};
}

/// Replaces the terms of all channels by jointly fitted ones. Returns the weighted squared norm of what they leave.
double fitJointly(const std::array<MaskedTensor, 3>& channels, const MeasuredNodes& measured, PdvFactors& factors,
                  const TaskControl& control) {
  std::array<double, 3> lefts{};
  parallelForBlocks(
      channels.size(), 1,
      [&](std::size_t channel, std::size_t) {
        std::vector<RankOne> terms;
        for (const PdvTerm& term : factors.channels[channel])
          terms.push_back({.a = term.f1, .b = term.f2, .c = term.f3, .residuals = {}});
        lefts[channel] =
            refineJointly(channels[channel], terms, {.firstNonnegative = true}, {.stop = control.stop, .progress = {}})
                .back();
        for (std::size_t l = 0; l < terms.size(); ++l)
          factors.channels[channel][l] = heldTerm(std::move(terms[l]), measured);
      },
      control);
  return lefts[0] + lefts[1] + lefts[2];
}

}  // namespace

PdvFactors PdvFactors::truncated(int count) const {
  PdvFactors result = *this;
  for (std::vector<PdvTerm>& channel : result.channels)
    channel.resize(std::min(channel.size(), std::size_t(std::max(1, count))));
  return result;
}

PdvOptions publishedPdvOptions(PdvForm form, int terms) {
  return {.form = form, .terms = terms, .weights = PdvWeights::equal, .deviationNodes = libraryDeviationNodes()};
}

PdvOptions compactPdvOptions(PdvOptions options) {
  options.thetaNodes = 60;
  options.phiNodes = 30;
  return options;
}

PdvFactorization factorizePdv(const TabulatedBrdf& table, const PdvOptions& options, const TaskControl& control) {
  const double preparationFraction = 0.2, termsEnd = options.joint ? 0.4 : 1;
  const auto start = std::chrono::steady_clock::now();
  PdvFactorization result{.factors = makeAxes(table, options, {.stop = control.stop})};
  PdvSamples samples = samplePdv(table, result.factors, options.weights, {.stop = control.stop});
  result.cells = samples.cells;
  std::array<MaskedTensor, 3>& channels = samples.channels;
  double total = 0;
  for (const MaskedTensor& channel : channels) {
    total += channel.squaredNorm();
    const auto [least, most] = std::minmax_element(channel.values.begin(), channel.values.end());
    result.factors.lowest = std::min(result.factors.lowest, double(*least));
    result.factors.highest = std::max(result.factors.highest, double(*most));
  }
  result.residuals.push_back(total > 0 ? 1 : 0);
  const MeasuredNodes measured{measuredNodes(channels[0], 0), measuredNodes(channels[0], 1),
                               measuredNodes(channels[0], 2)};
  const std::array<MaskedTensor, 3> measurement = options.joint ? channels : std::array<MaskedTensor, 3>();
  const auto elapsed = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  result.termSeconds.push_back(elapsed());
  for (int term = 0; term < options.terms; ++term) {
    control.throwIfStopped();
    control.report(preparationFraction + (termsEnd - preparationFraction) * term / options.terms);
    double left = 0;
    std::array<double, 3> lefts{};
    parallelForBlocks(channels.size(), 1, [&](std::size_t channel, std::size_t) {
      RankOne best = bestRankOne(channels[channel], {.nonnegative = term == 0});
      subtract(channels[channel], best);
      lefts[channel] = channels[channel].squaredNorm();
      result.factors.channels[channel].push_back(heldTerm(std::move(best), measured));
    });
    for (const double channelLeft : lefts) left += channelLeft;
    result.residuals.push_back(total > 0 ? std::min(result.residuals.back(), std::sqrt(left / total)) : 0);
    result.termSeconds.push_back(elapsed());
  }
  if (options.joint && total > 0) {
    const double left = fitJointly(measurement, measured, result.factors, control.between(termsEnd, 1));
    result.residuals.back() = std::min(result.residuals.back(), std::sqrt(left / total));
    result.termSeconds.back() = elapsed();
  }
  control.report(1);
  result.seconds = elapsed();
  return result;
}

}  // namespace gonio::factorization
