// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_samples.h"

#include <algorithm>
#include <cmath>

#include "core/coordinates/projected_deviation.h"
#include "core/factorization/deviation_grid.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

/// Steps of phi over which the form with two factors takes its means.
constexpr std::size_t meanSteps = 180;
/// Weight of a cell beside the disk, in that of its neighbours on it.
constexpr double besideFraction = 0.01;
/// Added to all cells, in mean weights: with none, the mirror directions of grazing viewers are left free.
constexpr double evenSampleFraction = 2e-5;
/// The last nodes stand on the limit itself.
const double smallestSampleCosine = std::cos(maxPolarAngle) * (1 - 1e-9);

/// Differences of f between the borders of the nodes' cells, which lie midway between nodes and at the ends.
template <typename Function>
std::vector<double> cellDifferences(const std::vector<double>& nodes, const Function& f) {
  std::vector<double> result;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double before = i > 0 ? (nodes[i - 1] + nodes[i]) / 2 : nodes[i];
    const double after = i + 1 < nodes.size() ? (nodes[i] + nodes[i + 1]) / 2 : nodes[i];
    result.push_back(f(after) - f(before));
  }
  return result;
}

class Sampler {
 public:
  Sampler(const TabulatedBrdf& table, const PdvFactors& axes, PdvWeights weights)
      : table_(table), axes_(axes), weights_(weights), phis_(axes.phiNodes) {
    if (flat()) {
      phis_.clear();
      for (std::size_t k = 0; k < meanSteps; ++k) phis_.push_back(pi * double(k) / double(meanSteps - 1));
    }
    thetaMeasure_ = cellDifferences(axes.thetaNodes, [](double t) { return std::sin(t) * std::sin(t); });
    deviationMeasure_ = cellDifferences(axes.deviationNodes, [](double d) { return d * d; });
    phiMeasure_ = cellDifferences(phis_, [](double phi) { return phi; });
    for (MaskedTensor& channel : channels) {
      channel.sizes[0] = int(axes.thetaNodes.size());
      channel.sizes[1] = int(axes.deviationNodes.size());
      channel.sizes[2] = int(axes.phiNodes.size());
      channel.values.assign(channel.index(channel.sizes[0], 0, 0), 0);
      channel.weights.assign(channel.values.size(), 0);
    }
  }

  void sampleViewer(std::size_t i) {
    Row row;
    for (std::size_t j = 0; j < axes_.deviationNodes.size(); ++j) {
      read(i, j, row);
      for (std::size_t n = 0; n < row.nodes.size(); ++n) store(i, j, n, row);
      if (flat()) finishMean(channels[0].index(int(i), int(j), 0));
    }
  }

  std::array<MaskedTensor, 3> channels;

 private:
  /// The cells over phi that are on the disk; of each the pair and its mirror image in the plane of incidence.
  struct Row {
    std::vector<std::size_t> nodes;
    std::vector<DirectionPair> pairs;
    std::vector<Rgb> values;
    std::vector<std::uint8_t> measured;
  };

  bool flat() const { return axes_.phiNodes.size() == 1; }

  void read(std::size_t i, std::size_t j, Row& row) const {
    row.nodes.clear();
    row.pairs.clear();
    for (std::size_t k = 0; k < phis_.size(); ++k) {
      const auto at = fromProjectedDeviation({axes_.thetaNodes[i], axes_.deviationNodes[j], phis_[k]});
      const Direction &wi = at.pair.wi, &wo = at.pair.wo;
      if (!at.valid || wi.z < smallestSampleCosine) continue;
      row.nodes.push_back(k);
      row.pairs.push_back(at.pair);
      row.pairs.push_back({{wi.x, -wi.y, wi.z}, wo});
    }
    row.values.resize(row.pairs.size());
    row.measured.resize(row.pairs.size());
    table_.evaluate(row.pairs, row.values, TableLookup::trilinear, row.measured);
  }

  void store(std::size_t i, std::size_t j, std::size_t n, const Row& row) {
    const double count = row.measured[2 * n] + row.measured[2 * n + 1];
    if (!(count > 0)) return;
    const double cosI = row.pairs[2 * n].wi.z, cosO = row.pairs[2 * n].wo.z, cosines = cosineWeight(cosI, cosO);
    const double measure = thetaMeasure_[i] * deviationMeasure_[j] * phiMeasure_[row.nodes[n]] * cosI * cosO;
    const std::size_t at = channels[0].index(int(i), int(j), flat() ? 0 : int(row.nodes[n]));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      double y = 0, rho = 0;
      for (std::size_t side = 2 * n; side < 2 * n + 2; ++side) {
        if (!row.measured[side]) continue;
        const double value = row.values[side][int(channel)];
        rho += value / count;
        y += transformedSigned(axes_.transform, value, cosines) / count;
      }
      double weight = 1;
      if (weights_ == PdvWeights::projectedSolidAngle)
        weight = measure * std::sqrt(inverseSlope(axes_.transform, std::abs(rho), cosines));
      MaskedTensor& t = channels[channel];
      t.values[at] = flat() ? t.values[at] + float(weight * y) : float(y);
      t.weights[at] += float(weight);
    }
  }

  /// The weighted sum over phi becomes a mean.
  void finishMean(std::size_t at) {
    for (MaskedTensor& t : channels)
      if (t.weights[at] > 0) t.values[at] /= t.weights[at];
  }

  const TabulatedBrdf& table_;
  const PdvFactors& axes_;
  PdvWeights weights_;
  std::vector<double> phis_, thetaMeasure_, deviationMeasure_, phiMeasure_;
};

/// Where a cell or one beside it is set, corners among them.
std::vector<std::uint8_t> widenedByOne(std::vector<std::uint8_t> cells, const MaskedTensor& shape) {
  std::size_t stride = 1;
  for (int mode = 2; mode >= 0; --mode) {
    const auto size = std::size_t(shape.sizes[mode]);
    const std::vector<std::uint8_t> before = cells;
    for (std::size_t at = 0; at < cells.size(); ++at) {
      const std::size_t node = at / stride % size;
      if (node > 0) cells[at] |= before[at - stride];
      if (node + 1 < size) cells[at] |= before[at + stride];
    }
    stride *= size;
  }
  return cells;
}

/// Sets a cell to the weighted mean of those about it that count.
void fillFromNeighbours(MaskedTensor& t, const std::vector<std::uint8_t>& counts, std::size_t cell) {
  const int n = t.sizes[1], p = t.sizes[2], i = int(cell) / (n * p), j = int(cell) / p % n, k = int(cell) % p;
  double sum = 0, weights = 0, neighbours = 0;
  for (int a = std::max(0, i - 1); a <= std::min(t.sizes[0] - 1, i + 1); ++a)
    for (int b = std::max(0, j - 1); b <= std::min(n - 1, j + 1); ++b)
      for (int c = std::max(0, k - 1); c <= std::min(p - 1, k + 1); ++c) {
        const std::size_t at = t.index(a, b, c);
        if (!counts[at]) continue;
        sum += double(t.weights[at]) * double(t.values[at]);
        weights += double(t.weights[at]);
        ++neighbours;
      }
  t.values[cell] = float(sum / weights);
  t.weights[cell] = float(besideFraction * weights / neighbours);
}

void addEvenFraction(MaskedTensor& t, std::size_t cells) {
  double total = 0;
  for (const float weight : t.weights) total += double(weight);
  for (float& weight : t.weights)
    if (weight > 0) weight += float(evenSampleFraction * total / double(cells));
}

}  // namespace

PdvSamples samplePdv(const TabulatedBrdf& table, const PdvFactors& axes, PdvWeights weights,
                     const TaskControl& control) {
  Sampler sampler(table, axes, weights);
  parallelForBlocks(
      axes.thetaNodes.size(), 1, [&](std::size_t i, std::size_t) { sampler.sampleViewer(i); }, control);
  PdvSamples samples{.channels = std::move(sampler.channels)};
  const MaskedTensor& shape = samples.channels[0];
  std::vector<std::uint8_t> counts(shape.weights.size());
  for (std::size_t at = 0; at < counts.size(); ++at) samples.cells += counts[at] = shape.weights[at] > 0;
  if (weights == PdvWeights::projectedSolidAngle)
    for (MaskedTensor& channel : samples.channels) addEvenFraction(channel, samples.cells);
  const std::vector<std::uint8_t> reached = widenedByOne(counts, shape);
  parallelForBlocks(counts.size(), counts.size() / axes.thetaNodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; ++at)
      for (MaskedTensor& channel : samples.channels)
        if (reached[at] && !counts[at]) fillFromNeighbours(channel, counts, at);
  });
  return samples;
}

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
