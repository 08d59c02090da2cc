// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/deviation_grid.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/coordinates/projected_deviation.h"
#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

constexpr double logarithmicNodes[] = {0,
                                       0.000584449785,
                                       0.0011797366,
                                       0.00180165241,
                                       0.00245048704,
                                       0.00311782569,
                                       0.0038141279,
                                       0.00453573541,
                                       0.00528002845,
                                       0.00605050185,
                                       0.0068615882,
                                       0.00770538009,
                                       0.00858222632,
                                       0.00949476446,
                                       0.0104447425,
                                       0.0114341524,
                                       0.0124682659,
                                       0.0135541765,
                                       0.0146941752,
                                       0.0158889188,
                                       0.0171476282,
                                       0.0184756212,
                                       0.0198704642,
                                       0.0213449644,
                                       0.0229028219,
                                       0.0245677443,
                                       0.0263327919,
                                       0.0282064407,
                                       0.0302012675,
                                       0.0323261848,
                                       0.0345861329,
                                       0.0370031041,
                                       0.0395935538,
                                       0.042348127,
                                       0.0452763474,
                                       0.0483835133,
                                       0.0516855964,
                                       0.0551994267,
                                       0.0589247604,
                                       0.0628674393,
                                       0.0670383261,
                                       0.0714788523,
                                       0.0761928931,
                                       0.0811879244,
                                       0.0864775233,
                                       0.0921113581,
                                       0.0981100897,
                                       0.104485848,
                                       0.111265928,
                                       0.118520118,
                                       0.126259942,
                                       0.13450658,
                                       0.143335369,
                                       0.152770521,
                                       0.162829416,
                                       0.173598682,
                                       0.185096407,
                                       0.197372097,
                                       0.210511287,
                                       0.224522315,
                                       0.239506002,
                                       0.255479996,
                                       0.272532738,
                                       0.290701375,
                                       0.310054192,
                                       0.330604884,
                                       0.352416754,
                                       0.375475082,
                                       0.399854481,
                                       0.425528569,
                                       0.452555448,
                                       0.480962069,
                                       0.510755232,
                                       0.541999201,
                                       0.57471468,
                                       0.60893327,
                                       0.644752824,
                                       0.682311968,
                                       0.721724666,
                                       0.763221595,
                                       0.807105057,
                                       0.853827277,
                                       0.904114334,
                                       0.959239505,
                                       1.02351816,
                                       1.10403296,
                                       1.20282322,
                                       1.32869705,
                                       1.50531473,
                                       1.99969539};

/// Of the energy rho.
constexpr double printedNodes[] = {0,
                                   5.03136654e-05,
                                   0.000100627331,
                                   0.000150940996,
                                   0.000201254662,
                                   0.000251568327,
                                   0.000301881993,
                                   0.000352195658,
                                   0.000402509324,
                                   0.000452822989,
                                   0.000503136654,
                                   0.00055345032,
                                   0.000603763985,
                                   0.000654077651,
                                   0.000704391316,
                                   0.000754704982,
                                   0.000805018647,
                                   0.000855332313,
                                   0.000905645978,
                                   0.000955959643,
                                   0.00101107018,
                                   0.00109894417,
                                   0.00118681816,
                                   0.00127469216,
                                   0.00136256615,
                                   0.00145044014,
                                   0.00153831413,
                                   0.00162618812,
                                   0.00171406212,
                                   0.00180193611,
                                   0.0018898101,
                                   0.00197768409,
                                   0.00209324015,
                                   0.00221804755,
                                   0.00234285495,
                                   0.00246766235,
                                   0.00259246975,
                                   0.00271727714,
                                   0.00284208454,
                                   0.00296689194,
                                   0.0031208664,
                                   0.0032851748,
                                   0.00344948321,
                                   0.00361379161,
                                   0.00377810001,
                                   0.00394240841,
                                   0.00413507659,
                                   0.00434280175,
                                   0.00455052691,
                                   0.00475825207,
                                   0.00496597722,
                                   0.00521448376,
                                   0.0054707652,
                                   0.00572704663,
                                   0.00598332807,
                                   0.00629279985,
                                   0.00660575644,
                                   0.00691871304,
                                   0.00727696088,
                                   0.00765081999,
                                   0.00802941762,
                                   0.0084716823,
                                   0.00891394699,
                                   0.0094181277,
                                   0.00993697129,
                                   0.0105303502,
                                   0.0111551514,
                                   0.0118538946,
                                   0.0126396414,
                                   0.0135183325,
                                   0.0145182916,
                                   0.0156694846,
                                   0.0170112263,
                                   0.0186539471,
                                   0.0206453532,
                                   0.0231322832,
                                   0.0263793826,
                                   0.0306718906,
                                   0.0365286179,
                                   0.0447593514,
                                   0.0564451247,
                                   0.0733192877,
                                   0.0984191971,
                                   0.137196933,
                                   0.198684356,
                                   0.295812834,
                                   0.442502885,
                                   0.647187292,
                                   0.932293312,
                                   1.99969539};

constexpr std::size_t steps = 2000;
constexpr double evenFraction = 1.0 / 3;
constexpr int viewers = 30, azimuths = 8;

enum class AzimuthCount { same, onDisk };

/// Sum of transformed values over viewers, azimuths on the disk, and channels, at one deviation. A sum, not a mean:
/// deviations with few valid pairs get few nodes. @param counted whether the weight of each viewer is the same number
/// of azimuths, or the part of the circle that is on the disk.
double energyAt(const Brdf& brdf, double deviation, AzimuthCount counted, DataTransform transform) {
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  for (int i = 0; i < viewers; ++i) {
    const double thetaR = halfPi * i / viewers, limit = azimuthLimit(deviation, std::sin(thetaR));
    for (int k = 0; k < azimuths && limit > 0; ++k) {
      const auto at = fromProjectedDeviation({thetaR, deviation, limit * (k + 0.5) / azimuths});
      if (!at.valid) continue;
      pairs.push_back(at.pair);
      weights.push_back(counted == AzimuthCount::onDisk ? limit / pi : 1);
    }
  }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      sum += weights[i] * transformed(transform, std::max(0.0, values[i][channel]), 1);
  return sum;
}

/// Adds the energy of a material at every step.
void addEnergy(std::vector<double>& energy, const Brdf& brdf, AzimuthCount counted, DataTransform transform,
               const TaskControl& control) {
  parallelForBlocks(
      steps, 50,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j)
          energy[j] += energyAt(brdf, (double(j) + 0.5) * maxDeviation / steps, counted, transform);
      },
      control);
}

}  // namespace

std::vector<double> libraryDeviationNodes(DataTransform energy) {
  if (energy == DataTransform::none) return {std::begin(printedNodes), std::end(printedNodes)};
  return {std::begin(logarithmicNodes), std::end(logarithmicNodes)};
}

std::vector<double> deviationNodes(std::span<const double> energy, int count) {
  constexpr double smallestGap = 1e-6;
  std::vector<double> cumulative{0};
  for (const double e : energy) cumulative.push_back(cumulative.back() + e);
  const double total = cumulative.back(), step = maxDeviation / double(energy.size());
  std::vector<double> nodes;
  std::size_t at = 0;
  for (int k = 0; k < count; ++k) {
    const double fraction = double(k) / (count - 1);
    double node = maxDeviation * fraction;
    if (total > 0) {
      const double wanted = fraction * total;
      while (at + 1 < energy.size() && cumulative[at + 1] < wanted) ++at;
      const double part = energy[at] > 0 ? (wanted - cumulative[at]) / energy[at] : 0;
      node = step * (double(at) + std::clamp(part, 0.0, 1.0));
    }
    nodes.push_back(nodes.empty() ? 0 : std::max(node, nodes.back() + smallestGap));
  }
  nodes.back() = maxDeviation;
  for (std::size_t k = nodes.size() - 1; k-- > 1;) nodes[k] = std::min(nodes[k], nodes[k + 1] - smallestGap);
  return nodes;
}

std::vector<double> deviationNodes(std::span<const std::shared_ptr<const TabulatedBrdf>> tables, int count,
                                   const TaskControl& control) {
  std::vector<double> energy(steps, 0.0);
  for (const auto& table : tables) addEnergy(energy, *table, AzimuthCount::same, DataTransform::logPlus, control);
  double total = 0;
  for (const double e : energy) total += e;
  for (double& e : energy) e = (1 - evenFraction) * e + evenFraction * total / double(steps);
  return deviationNodes(energy, count);
}

std::vector<double> publishedDeviationEnergy(const Brdf& brdf, const TaskControl& control, DataTransform transform) {
  std::vector<double> energy(steps, 0.0);
  addEnergy(energy, brdf, AzimuthCount::onDisk, transform, control);
  return energy;
}

}  // namespace gonio::factorization
