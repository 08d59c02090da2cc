// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/brdf_metrics.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/brdf/mirrored_nodes.h"
#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"
#include "core/metrics/decibels.h"
#include "core/metrics/metric_domain.h"

namespace gonio::metrics {

namespace {

/// The reference's cells of one block that pass a filter.
struct Cells {
  std::vector<std::size_t> indices;
  std::vector<DirectionPair> pairs;
  std::vector<Rgb> test;
};

/// What is compared: pairs of directions with both values and their weights.
struct Compared {
  std::span<const DirectionPair> pairs;
  std::span<const Rgb> reference, test;
  std::span<const double> measures;
};

/// Leaves out cells that the test, being a table as well, does not know.
void evaluateTest(const TabulatedBrdf& reference, const Brdf& test, Cells& cells) {
  cells.test.assign(cells.pairs.size(), Rgb(0));
  const TabulatedBrdf* table = test.asTable();
  if (!table) {
    evaluateNodes(test, reference.grid(), cells.indices, cells.pairs, cells.test);
    for (Rgb& value : cells.test) value = glm::max(value, Rgb(0));
    return;
  }
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

/// Cells at a time: what all metrics look at stays in the caches.
constexpr std::size_t block = 1024;

/// Weighted sums over the cells of a block, one of each a metric, in the order of metricRecords().
struct Sums {
  std::vector<double> deviations = std::vector<double>(metricRecords().size(), 0.0);
  std::vector<double> weights = std::vector<double>(metricRecords().size(), 0.0);
};

/// Sums the metrics asked for over one block of cells. Metrics of one factor and domain share their differences; all
/// share the weights. Its loops run over channels side by side, so that they become vector code.
class BlockSums {
 public:
  BlockSums(const Compared& cells, double gamma)
      : cells_(cells), gamma_(gamma), reference_(columns(cells.reference)), test_(columns(cells.test)) {
    differences_.resize(3, reference_.cols());
    powers_.resize(3, reference_.cols());
  }

  Sums sum(std::span<const BrdfMetric> wanted) {
    Sums sums;
    if (cells_.pairs.empty()) return sums;
    std::vector<bool> done(metricRecords().size(), false);
    for (const BrdfMetric metric : wanted) {
      const MetricRecord& first = metricRecord(metric);
      if (done[static_cast<std::size_t>(metric)]) continue;
      computeDifferences(first);
      for (const BrdfMetric other : wanted) {
        const MetricRecord& record = metricRecord(other);
        if (record.factor != first.factor || record.domain != first.domain) continue;
        const auto index = static_cast<std::size_t>(other);
        accumulate(record, sums.deviations[index], sums.weights[index]);
        done[index] = true;
      }
    }
    return sums;
  }

 private:
  using Array = Eigen::Array3Xd;  ///< a column for each pair
  /// The number of each pair, in all channels, and their sum over the pairs.
  struct OfPairs {
    Array columns;
    double sum = 0;
  };

  static Array columns(std::span<const Rgb> values) {
    if (values.empty()) return {};
    return Eigen::Map<const Array>(glm::value_ptr(values.front()), 3, Eigen::Index(values.size())).max(0);
  }

  /// Made on first use.
  template <typename ValueAt>
  const OfPairs& ofPairs(std::optional<OfPairs>& known, const ValueAt& valueAt) const {
    if (known) return *known;
    known = OfPairs{};
    known->columns.resize(3, reference_.cols());
    double* column = known->columns.data();
    for (std::size_t i = 0; i < cells_.pairs.size(); ++i, column += 3) {
      const double value = valueAt(i);
      column[0] = column[1] = column[2] = value;
      known->sum += value;
    }
    return *known;
  }
  const Array& factors(MetricFactor factor) {
    return ofPairs(factors_[static_cast<std::size_t>(factor)],
                   [&](std::size_t i) {
                     const DirectionPair& pair = cells_.pairs[i];
                     return metricFactor(factor, pair.wi.z, pair.wo.z);
                   })
        .columns;
  }
  const OfPairs& weights(MetricWeight weight) {
    return ofPairs(weights_[static_cast<std::size_t>(weight)], [&](std::size_t i) {
      const DirectionPair& pair = cells_.pairs[i];
      return cells_.measures[i] * metricWeight(weight, pair.wi.z, pair.wo.z);
    });
  }

  void computeDifferences(const MetricRecord& record) {
    if (record.domain == MetricDomain::lab) {
      labDifferences(reference_, test_, differences_);
      return;
    }
    const double* factor = factors(record.factor).data();
    visitDifference(record.domain, gamma_, [&](const auto& difference) {
      const double *r = reference_.data(), *t = test_.data();
      double* d = differences_.data();
      for (Eigen::Index i = 0; i < differences_.size(); ++i) d[i] = difference(factor[i] * r[i], factor[i] * t[i]);
    });
  }

  void accumulate(const MetricRecord& record, double& deviation, double& weightSum) {
    visitPower(record.power, [&](const auto& power) {
      const double* d = differences_.data();
      double* p = powers_.data();
      for (Eigen::Index i = 0; i < differences_.size(); ++i) p[i] = power(d[i]);
    });
    const OfPairs& weight = weights(record.weight);
    weightSum += (record.domain == MetricDomain::lab ? 1 : 3) * weight.sum;
    deviation += (weight.columns * powers_).sum();
  }

  Compared cells_;
  double gamma_;
  Array reference_, test_, differences_, powers_;
  std::array<std::optional<OfPairs>, 3> factors_, weights_;
};

Sums sumsOfBlock(std::span<const BrdfMetric> wanted, const TabulatedBrdf& reference, const Cells& cells, double gamma) {
  std::vector<Rgb> values(cells.indices.size());
  std::vector<double> measures(cells.indices.size());
  const auto rowLength = std::size_t(reference.grid().phiDCount);
  std::size_t row = std::size_t(-1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t cell = cells.indices[i];
    values[i] = Rgb(reference.values()[cell]);
    // The same for all phi_d.
    measures[i] = cell / rowLength == row ? measures[i - 1] : reference.grid().cellMeasure(cell);
    row = cell / rowLength;
  }
  return BlockSums({cells.pairs, values, cells.test, measures}, gamma).sum(wanted);
}

std::vector<double> errorsOf(std::span<const Sums> blocks) {
  std::vector<double> errors(metricRecords().size(), 0.0);
  for (std::size_t m = 0; m < errors.size(); ++m) {
    double deviation = 0, weight = 0;
    for (const Sums& sums : blocks) {
      deviation += sums.deviations[m];
      weight += sums.weights[m];
    }
    if (!(weight > 0)) continue;
    errors[m] = metricRecords()[m].isRoot ? std::sqrt(deviation / weight) : deviation / weight;
  }
  return errors;
}

/// In the order of metricRecords(); 0 for metrics that are not wanted.
std::vector<double> errorsBy(std::span<const BrdfMetric> wanted, const TabulatedBrdf& reference, const Brdf& test,
                             double maxPolarAngle, double gamma) {
  const std::size_t count = reference.grid().size();
  const double minCosine = smallestCosine(maxPolarAngle);
  const GridDirections directions(reference.grid());
  std::vector<Sums> blocks((count + block - 1) / block);
  parallelForBlocks(count, block, [&](std::size_t begin, std::size_t end) {
    const Cells cells = cellsOfBlock(reference, directions, test, begin, end, minCosine);
    blocks[begin / block] = sumsOfBlock(wanted, reference, cells, gamma);
  });
  return errorsOf(blocks);
}

}  // namespace

double brdfError(BrdfMetric metric, const TabulatedBrdf& reference, const Brdf& test, double maxPolarAngle,
                 double gamma) {
  return errorsBy(std::span(&metric, 1), reference, test, maxPolarAngle, gamma)[static_cast<std::size_t>(metric)];
}

std::vector<double> brdfErrors(const TabulatedBrdf& reference, const Brdf& test, double maxPolarAngle, double gamma) {
  return errorsBy(allBrdfMetrics(), reference, test, maxPolarAngle, gamma);
}

std::vector<double> brdfErrors(std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                               std::span<const double> measures, const Brdf& test, double gamma) {
  std::vector<Sums> blocks((pairs.size() + block - 1) / block);
  parallelForBlocks(pairs.size(), block, [&](std::size_t begin, std::size_t end) {
    const std::size_t count = end - begin;
    std::vector<Rgb> tested(count);
    test.evaluate(pairs.subspan(begin, count), tested);
    const Compared compared{pairs.subspan(begin, count), values.subspan(begin, count), tested,
                            measures.subspan(begin, count)};
    blocks[begin / block] = BlockSums(compared, gamma).sum(allBrdfMetrics());
  });
  return errorsOf(blocks);
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
