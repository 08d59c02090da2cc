// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/brdf_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"
#include "core/metrics/decibels.h"
#include "core/support/error.h"

namespace gonio::metrics {

namespace {

struct NamedMetric {
  BrdfMetric metric;
  std::string_view name;
};
constexpr std::array namedMetrics{NamedMetric{BrdfMetric::log, "log"}, NamedMetric{BrdfMetric::cosineL2, "cosine-l2"},
                                  NamedMetric{BrdfMetric::cubeRoot, "cube-root"},
                                  NamedMetric{BrdfMetric::meanAbsoluteLog, "mean-absolute-log"}};
constexpr std::size_t metricCount = namedMetrics.size();
constexpr std::array metrics{BrdfMetric::log, BrdfMetric::cosineL2, BrdfMetric::cubeRoot, BrdfMetric::meanAbsoluteLog};

/// A measurement error can leave a reconstruction below 0, where a root is undefined.
double reflected(double value, double cosI) { return std::max(0.0, value) * cosI; }

using PerMetric = std::array<double, metricCount>;  ///< in the order of `metrics`

/// What the metrics sum over the channels of one cell.
PerMetric deviations(const Rgb& reference, const Rgb& test, double cosI) {
  double logSquared = 0, linearSquared = 0, rootSquared = 0, logAbsolute = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double r = reflected(reference[channel], cosI), t = reflected(test[channel], cosI);
    // log((1 + r) / (1 + t)) without cancellation for small values.
    const double log = std::log1p((r - t) / (1 + t)), linear = r - t, root = std::cbrt(r) - std::cbrt(t);
    logSquared += log * log;
    logAbsolute += std::abs(log);
    linearSquared += linear * linear;
    rootSquared += root * root;
  }
  return {logSquared, linearSquared, rootSquared, logAbsolute};
}

/// The reference's cells of one block that pass a filter, with both values.
struct Cells {
  std::vector<std::size_t> indices;
  std::vector<DirectionPair> pairs;
  std::vector<Rgb> test;
};

/// Leaves out cells that the test, being a table as well, does not know.
void evaluateTest(const TabulatedBrdf& reference, const Brdf& test, Cells& cells) {
  cells.test.assign(cells.pairs.size(), Rgb(0));
  const auto* table = dynamic_cast<const TabulatedBrdf*>(&test);
  if (!table) return test.evaluate(cells.pairs, cells.test);
  const bool sameGrid = table->grid() == reference.grid();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cells.indices.size(); ++i) {
    const std::size_t cell = cells.indices[i];
    bool valid = false;
    Rgb value;
    if (sameGrid) {
      valid = table->valid()[cell] != 0;
      value = Rgb(table->values()[cell]);
    } else {
      value = table->lookup(reference.grid().node(cell), TableLookup::trilinear, &valid);
    }
    if (!valid) continue;
    cells.indices[kept] = cell;
    cells.pairs[kept] = cells.pairs[i];
    cells.test[kept++] = value;
  }
  cells.indices.resize(kept);
  cells.pairs.resize(kept);
  cells.test.resize(kept);
}

/// Valid cells of [begin, end) whose cosines are at least `minCosine`; below the horizon a cosine counts as 0.
Cells cellsOfBlock(const TabulatedBrdf& reference, const GridDirections& directions, const Brdf& test,
                   std::size_t begin, std::size_t end, double minCosine) {
  Cells cells;
  cells.indices.reserve(end - begin);
  cells.pairs.reserve(end - begin);
  for (std::size_t cell = begin; cell < end; ++cell) {
    if (!reference.valid()[cell]) continue;
    DirectionPair pair = directions.at(cell).pair;
    if (pair.wi.z < minCosine || pair.wo.z < minCosine) continue;
    pair.wi.z = std::max(0.0, pair.wi.z);
    pair.wo.z = std::max(0.0, pair.wo.z);
    cells.indices.push_back(cell);
    cells.pairs.push_back(pair);
  }
  evaluateTest(reference, test, cells);
  return cells;
}

/// Cells that lie at the greatest angle exactly count, whatever the rounding of their directions.
double smallestCosine(double maxPolarAngle) { return std::cos(maxPolarAngle) - 1e-12; }

constexpr std::size_t block = 8192;

struct Sums {
  PerMetric deviations{};
  double weight = 0;
};

Sums sumDeviations(const TabulatedBrdf& reference, const Cells& cells) {
  Sums sums;
  const auto rowLength = std::size_t(reference.grid().phiDCount);
  std::size_t row = std::size_t(-1);
  double weight = 0;
  for (std::size_t i = 0; i < cells.indices.size(); ++i) {
    const std::size_t cell = cells.indices[i];
    if (cell / rowLength != row) {
      row = cell / rowLength;
      weight = reference.grid().cellMeasure(cell);  // the same for all phi_d
    }
    const Rgb value(reference.values()[cell]);
    sums.weight += 3 * weight;
    const PerMetric found = deviations(value, cells.test[i], cells.pairs[i].wi.z);
    for (std::size_t m = 0; m < metricCount; ++m) sums.deviations[m] += weight * found[m];
  }
  return sums;
}

}  // namespace

std::span<const BrdfMetric> allBrdfMetrics() { return metrics; }

std::string_view metricName(BrdfMetric metric) {
  for (const NamedMetric& named : namedMetrics)
    if (named.metric == metric) return named.name;
  return {};
}

BrdfMetric metricByName(std::string_view name) {
  std::string known;
  for (const NamedMetric& named : namedMetrics) {
    if (named.name == name) return named.metric;
    known += (known.empty() ? "" : ", ") + std::string(named.name);
  }
  throw Error("there is no metric named '" + std::string(name) + "'; the metrics are " + known);
}

double brdfError(BrdfMetric metric, const TabulatedBrdf& reference, const Brdf& test, double maxPolarAngle) {
  const std::vector<double> errors = brdfErrors(reference, test, maxPolarAngle);
  for (std::size_t i = 0; i < metricCount; ++i)
    if (metrics[i] == metric) return errors[i];
  return 0;
}

std::vector<double> brdfErrors(const TabulatedBrdf& reference, const Brdf& test, double maxPolarAngle) {
  const std::size_t count = reference.grid().size();
  const double minCosine = smallestCosine(maxPolarAngle);
  const GridDirections directions(reference.grid());
  std::vector<Sums> blocks((count + block - 1) / block);
  parallelForBlocks(count, block, [&](std::size_t begin, std::size_t end) {
    const Cells cells = cellsOfBlock(reference, directions, test, begin, end, minCosine);
    blocks[begin / block] = sumDeviations(reference, cells);
  });
  Sums total;
  for (const Sums& sums : blocks) {
    total.weight += sums.weight;
    for (std::size_t m = 0; m < metricCount; ++m) total.deviations[m] += sums.deviations[m];
  }
  std::vector<double> errors(metricCount, 0.0);
  if (!(total.weight > 0)) return errors;
  for (std::size_t m = 0; m < metricCount; ++m) {
    const double mean = total.deviations[m] / total.weight;
    errors[m] = metrics[m] == BrdfMetric::meanAbsoluteLog ? mean : std::sqrt(mean);
  }
  return errors;
}

double brdfSignalToNoiseRatio(const TabulatedBrdf& reference, const Brdf& test) {
  const std::size_t count = reference.grid().size();
  const GridDirections directions(reference.grid());
  std::vector<glm::dvec2> blocks((count + block - 1) / block, glm::dvec2(0));
  parallelForBlocks(count, block, [&](std::size_t begin, std::size_t end) {
    // Tables hold cells a little below the horizon as well: their cosine is 0.
    const Cells cells = cellsOfBlock(reference, directions, test, begin, end, -1);
    for (std::size_t i = 0; i < cells.indices.size(); ++i) {
      const double cosines = cells.pairs[i].wi.z * cells.pairs[i].wo.z;
      const Rgb signal = Rgb(reference.values()[cells.indices[i]]) * cosines;
      const Rgb noise = signal - cells.test[i] * cosines;
      blocks[begin / block] += glm::dvec2(glm::dot(signal, signal), glm::dot(noise, noise));
    }
  });
  glm::dvec2 total(0);
  for (const glm::dvec2& sums : blocks) total += sums;
  return decibels(total.x, total.y);
}

}  // namespace gonio::metrics
