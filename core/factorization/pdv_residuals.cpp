// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_residuals.h"

#include <cmath>

#include "core/factorization/pdv_samples.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

/// Weighted squares of a tensor, summed over the cells at each node.
PdvResidualsAlong squaresAlong(const MaskedTensor& t) {
  PdvResidualsAlong sums;
  for (std::size_t axis = 0; axis < 3; ++axis) sums[axis].assign(std::size_t(t.sizes[axis]), 0);
  for (int i = 0; i < t.sizes[0]; ++i)
    for (int j = 0; j < t.sizes[1]; ++j) {
      double row = 0;
      for (int k = 0; k < t.sizes[2]; ++k) {
        const std::size_t at = t.index(i, j, k);
        const double square = double(t.weights[at]) * t.values[at] * t.values[at];
        sums[2][std::size_t(k)] += square;
        row += square;
      }
      sums[0][std::size_t(i)] += row;
      sums[1][std::size_t(j)] += row;
    }
  return sums;
}

void add(PdvResidualsAlong& sum, const PdvResidualsAlong& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum[axis].resize(other[axis].size(), 0);
    for (std::size_t i = 0; i < other[axis].size(); ++i) sum[axis][i] += other[axis][i];
  }
}

}  // namespace

std::vector<PdvResidualsAlong> residualsAlong(const TabulatedBrdf& table, const PdvFactors& factors, PdvWeights weights,
                                              const TaskControl& control) {
  PdvSamples samples = samplePdv(table, factors, weights, {.stop = control.stop});
  const auto terms = std::size_t(factors.terms());
  std::array<std::vector<PdvResidualsAlong>, 3> ofChannels;
  parallelForBlocks(3, 1, [&](std::size_t channel, std::size_t) {
    MaskedTensor& tensor = samples.channels[channel];
    ofChannels[channel].push_back(squaresAlong(tensor));
    for (const PdvTerm& term : factors.channels[channel]) {
      subtract(tensor, {.a = term.f1, .b = term.f2, .c = term.f3, .residuals = {}});
      ofChannels[channel].push_back(squaresAlong(tensor));
    }
  });
  std::vector<PdvResidualsAlong> sums(terms + 1);
  for (std::size_t count = 0; count <= terms; ++count)
    for (const auto& channel : ofChannels) add(sums[count], channel[count]);
  for (std::size_t count = 1; count <= terms; ++count)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < sums[count][axis].size(); ++i) {
        const double all = sums[0][axis][i];
        sums[count][axis][i] = all > 0 ? std::sqrt(sums[count][axis][i] / all) : 0;
      }
  sums.erase(sums.begin());
  return sums;
}

}  // namespace gonio::factorization
