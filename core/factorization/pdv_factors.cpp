// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_factors.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "core/coordinates/half_difference_block.h"
#include "core/coordinates/projected_deviation.h"
#include "core/factorization/deviation_grid.h"
#include "core/factorization/masked_rank_one.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

constexpr int thetaCount = 90, phiCount = 180;
/// How far above the largest transformed value of the measurement the model may go.
constexpr double headroom = 2;
/// The last nodes stand on the limit itself.
const double smallestCosine = std::cos(largestPolarAngle) * (1 - 1e-9);

std::vector<double> evenNodes(int count, double last) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(last * i / (count - 1));
  return nodes;
}

/// The measurement over the nodes: transformed, the mean of phi and -phi, one tensor a channel with the same mask.
class Samples {
 public:
  Samples(const TabulatedBrdf& table, const PdvFactors& axes, const TaskControl& control)
      : table_(table), axes_(axes), phis_(evenNodes(phiCount, pi)) {
    for (MaskedTensor& channel : channels_) {
      channel.sizes[0] = int(axes.thetaNodes.size());
      channel.sizes[1] = int(axes.deviationNodes.size());
      channel.sizes[2] = int(axes.phiNodes.size());
      const std::size_t count = channel.index(channel.sizes[0], 0, 0);
      channel.values.assign(count, 0);
      channel.mask.assign(count, 0);
    }
    parallelForBlocks(
        axes.thetaNodes.size(), 1, [&](std::size_t i, std::size_t) { sampleViewer(int(i)); }, control);
  }
  std::array<MaskedTensor, 3>& channels() { return channels_; }

 private:
  void sampleViewer(int i) {
    const bool flat = axes_.phiNodes.size() == 1;
    for (int j = 0; j < channels_[0].sizes[1]; ++j) {
      glm::dvec3 rowSum(0);
      double rowCount = 0;
      for (int k = 0; k < phiCount; ++k) {
        glm::dvec3 y;
        if (!sample(axes_.thetaNodes[std::size_t(i)], axes_.deviationNodes[std::size_t(j)], phis_[std::size_t(k)], y))
          continue;
        rowSum += y;
        ++rowCount;
        if (!flat) store(channels_[0].index(i, j, k), y);
      }
      if (flat && rowCount > 0) store(channels_[0].index(i, j, 0), rowSum / rowCount);
    }
  }

  void store(std::size_t at, const glm::dvec3& y) {
    for (int channel = 0; channel < 3; ++channel) {
      channels_[std::size_t(channel)].values[at] = float(y[channel]);
      channels_[std::size_t(channel)].mask[at] = 1;
    }
  }

  bool sample(double thetaR, double deviation, double phi, glm::dvec3& y) const {
    const ProjectedDirections at = fromProjectedDeviation({thetaR, deviation, phi});
    if (!at.valid || at.pair.wi.z < smallestCosine) return false;
    const double weight = cosineWeight(at.pair.wi.z, at.pair.wo.z);
    y = glm::dvec3(0);
    double count = 0;
    for (const double side : {1.0, -1.0}) {
      const Direction wi(at.pair.wi.x, side * at.pair.wi.y, at.pair.wi.z);
      bool measured = false;
      const Rgb rho = table_.lookup(toHalfDifference(wi, at.pair.wo), TableLookup::trilinear, &measured);
      if (!measured) continue;
      ++count;
      for (int channel = 0; channel < 3; ++channel) y[channel] += transformed(axes_.transform, rho[channel], weight);
    }
    if (count > 0) y /= count;
    return count > 0;
  }

  const TabulatedBrdf& table_;
  const PdvFactors& axes_;
  std::vector<double> phis_;
  std::array<MaskedTensor, 3> channels_;
};

PdvFactors makeAxes(const TabulatedBrdf& table, const PdvOptions& options, const TaskControl& control) {
  if (options.terms < 1 || options.terms > mostPdvTerms)
    throw Error("the count of terms is " + std::to_string(options.terms) + "; expected 1 to " +
                std::to_string(mostPdvTerms));
  PdvFactors axes{.form = options.form, .transform = options.transform};
  axes.thetaNodes = evenNodes(thetaCount, largestPolarAngle);
  axes.phiNodes = options.form == PdvForm::twoFactors ? std::vector{0.0} : evenNodes(phiCount, pi);
  axes.deviationNodes = options.deviationNodes;
  if (axes.deviationNodes.empty()) {
    // No owner: the table outlives the call.
    const std::shared_ptr<const TabulatedBrdf> unowned(std::shared_ptr<void>(), &table);
    axes.deviationNodes = deviationNodes(std::span(&unowned, 1), defaultDeviations, control);
  }
  const std::vector<double>& nodes = axes.deviationNodes;
  if (nodes.size() < 2 || nodes.front() != 0 || !std::is_sorted(nodes.begin(), nodes.end(), std::less_equal<>()))
    throw Error("the nodes of |Dp| must be at least two, rise strictly and begin with 0");
  return axes;
}

/// Which nodes of a mode hold a cell that counts.
std::vector<bool> measuredNodes(const MaskedTensor& t, int mode) {
  std::vector<bool> measured(std::size_t(t.sizes[mode]), false);
  for (int i = 0; i < t.sizes[0]; ++i)
    for (int j = 0; j < t.sizes[1]; ++j)
      for (int k = 0; k < t.sizes[2]; ++k)
        if (t.mask[t.index(i, j, k)] > 0) measured[std::size_t(mode == 0 ? i : mode == 1 ? j : k)] = true;
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

}  // namespace

PdvFactors PdvFactors::truncated(int count) const {
  PdvFactors result = *this;
  for (std::vector<PdvTerm>& channel : result.channels)
    channel.resize(std::min(channel.size(), std::size_t(std::max(1, count))));
  return result;
}

PdvFactorization factorizePdv(const TabulatedBrdf& table, const PdvOptions& options, const TaskControl& control) {
  constexpr double preparationShare = 0.2;
  const auto start = std::chrono::steady_clock::now();
  PdvFactorization result{.factors = makeAxes(table, options, {.stop = control.stop})};
  Samples samples(table, result.factors, {.stop = control.stop});
  auto& channels = samples.channels();
  double total = 0;
  for (const MaskedTensor& channel : channels) {
    total += channel.squaredNorm();
    for (const float y : channel.values) result.factors.highest = std::max(result.factors.highest, double(y));
  }
  result.factors.highest += headroom;
  result.cells = std::size_t(std::count(channels[0].mask.begin(), channels[0].mask.end(), 1.0f));
  result.residuals.push_back(total > 0 ? 1 : 0);
  const std::vector<bool> measured[] = {measuredNodes(channels[0], 0), measuredNodes(channels[0], 1),
                                        measuredNodes(channels[0], 2)};
  for (int term = 0; term < options.terms; ++term) {
    control.throwIfStopped();
    control.report(preparationShare + (1 - preparationShare) * term / options.terms);
    double left = 0;
    for (std::size_t channel = 0; channel < channels.size(); ++channel) {
      RankOne best = bestRankOne(channels[channel], {.nonnegative = term == 0});
      subtract(channels[channel], best);
      holdUnmeasured(best.a, measured[0]);
      holdUnmeasured(best.b, measured[1]);
      holdUnmeasured(best.c, measured[2]);
      left += channels[channel].squaredNorm();
      result.factors.channels[channel].push_back({best.a, best.b, best.c});
    }
    result.residuals.push_back(total > 0 ? std::min(result.residuals.back(), std::sqrt(left / total)) : 0);
  }
  control.report(1);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace gonio::factorization
