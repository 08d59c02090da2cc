// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/brdf_metrics.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "core/brdf/bake_table.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"
#include "core/math/types.h"
#include "core/metrics/brdf_metric.h"
#include "core/metrics/image_metrics.h"

namespace gonio::metrics {

namespace {

/// The directions at which two BRDFs are compared: the nodes of the reference if it is a table, else points in the
/// cells of a grid, since the nodes of a table that was made of the reference would be its best values.
class Nodes {
 public:
  Nodes(const Brdf& reference, const Brdf& test)
      : grid_(gridOf(reference, test)),
        areNodes_(formOf<TabulatedBrdf>(reference) != nullptr),
        directions_(grid_, areNodes_ ? GridPoints::nodes : GridPoints::scattered),
        isIsotropic_(reference.isIsotropic() && test.isIsotropic()) {}

  const HalfDifferenceGrid& grid() const { return grid_; }
  bool areNodes() const { return areNodes_; }
  bool isIsotropic() const { return isIsotropic_; }

  /// The directions of a node or cell, both with a cosine of at least `minCosine`. Tables contain nodes a little below
  /// the horizon, where a cosine counts as 0; points in cells are above it. Where a BRDF is anisotropic, each pair has
  /// an azimuth of its own; all are spread evenly over the circle.
  std::optional<DirectionPair> pair(std::size_t index, double minCosine) const {
    auto [pair, aboveHorizon] = directions_.at(index);
    if (!areNodes_ && !aboveHorizon) return std::nullopt;
    pair.wi.z = std::max(0.0, pair.wi.z);
    pair.wo.z = std::max(0.0, pair.wo.z);
    if (pair.wi.z < minCosine || pair.wo.z < minCosine) return std::nullopt;
    if (isIsotropic_) return pair;
    const double turns = double(index) * (std::numbers::phi - 1);
    return AzimuthRotation(2 * pi * (turns - std::floor(turns)))(pair);
  }

 private:
  static HalfDifferenceGrid gridOf(const Brdf& reference, const Brdf& test) {
    const TabulatedBrdf* table = formOf<TabulatedBrdf>(reference);
    if (!table) table = formOf<TabulatedBrdf>(test);
    HalfDifferenceGrid grid = table ? table->grid() : HalfDifferenceGrid();
    if (!grid.reciprocal || (reference.isReciprocal() && test.isReciprocal())) return grid;
    // A table keeps its nodes; otherwise the number of nodes stays the same.
    if (table) return grid.wholeCircle();
    grid.reciprocal = false;
    return grid;
  }

  HalfDifferenceGrid grid_;
  bool areNodes_;
  GridDirections directions_;
  bool isIsotropic_;
};

/// The nodes of one block at which both BRDFs have data.
struct Cells {
  std::vector<std::size_t> indices;
  std::vector<DirectionPair> pairs;
  std::vector<Rgb> reference, test;
};

/// The compared values: pairs of directions with both values and their weights.
struct Compared {
  std::span<const DirectionPair> pairs;
  std::span<const Rgb> reference, test;
  std::span<const double> measures;
};

/// The index of a node of `grid` in a table that has it: one of the same grid, or of its half circle.
std::optional<std::size_t> nodeIn(const HalfDifferenceGrid& table, const HalfDifferenceGrid& grid, std::size_t node) {
  if (table == grid) return node;
  if (!table.reciprocal || table.wholeCircle() != grid) return std::nullopt;
  const auto half = std::size_t(table.phiDCount);
  return node / (2 * half) * half + node % half;
}

/// The values of a table at nodes, and whether they are valid.
void lookUp(const TabulatedBrdf& table, const Nodes& nodes, std::span<const std::size_t> indices,
            std::vector<Rgb>& values, std::vector<bool>& known) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    bool valid = false;
    if (const auto node = nodeIn(table.grid(), nodes.grid(), indices[i])) {
      valid = table.valid()[*node] != 0;
      values[i] = Rgb(table.values()[*node]);
    } else {
      values[i] = table.lookup(nodes.grid().node(indices[i]), TableLookup::trilinear, &valid);
    }
    known[i] = valid;
  }
}

/// Leaves out the cells that are not known.
void keepKnown(const std::vector<bool>& known, Cells& cells) {
  if (std::ranges::all_of(known, std::identity())) return;
  const auto keep = [&](auto& list) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
      if (known[i]) list[kept++] = list[i];
    list.resize(kept);
  };
  keep(cells.indices);
  keep(cells.pairs);
  keep(cells.reference);
  keep(cells.test);
}

/// The values of a BRDF at the cells. Leaves out those at which it has no data.
void evaluateCells(const Brdf& brdf, const Nodes& nodes, Cells& cells, std::vector<Rgb> Cells::*of) {
  std::vector<Rgb>& values = cells.*of;
  values.assign(cells.pairs.size(), Rgb(0));
  std::vector<bool> known(values.size(), true);
  const TabulatedBrdf* table = formOf<TabulatedBrdf>(brdf);
  if (table && nodes.areNodes()) {
    lookUp(*table, nodes, cells.indices, values, known);
  } else if (table) {
    std::vector<std::uint8_t> measured(values.size());
    table->evaluate(cells.pairs, values, TableLookup::trilinear, measured);
    known.assign(measured.begin(), measured.end());
  } else {
    if (nodes.isIsotropic())
      evaluateNodes(brdf, nodes.grid(), cells.indices, cells.pairs, values);
    else
      brdf.evaluate(cells.pairs, values);
    for (std::size_t i = 0; i < values.size(); ++i) known[i] = values[i] != Rgb(0) || brdf.hasData(cells.pairs[i]);
  }
  keepKnown(known, cells);
}

/// The directions of the cells of [begin, end) with cosines of at least `minCosine`.
Cells directionsOfBlock(const Nodes& nodes, std::size_t begin, std::size_t end, double minCosine) {
  Cells cells;
  cells.indices.reserve(end - begin);
  cells.pairs.reserve(end - begin);
  for (std::size_t node = begin; node < end; ++node) {
    const std::optional<DirectionPair> pair = nodes.pair(node, minCosine);
    if (!pair) continue;
    cells.indices.push_back(node);
    cells.pairs.push_back(*pair);
  }
  return cells;
}

/// The same with the values of both BRDFs, where both have data.
Cells cellsOfBlock(const Brdf& reference, const Brdf& test, const Nodes& nodes, std::size_t begin, std::size_t end,
                   double minCosine) {
  Cells cells = directionsOfBlock(nodes, begin, end, minCosine);
  evaluateCells(reference, nodes, cells, &Cells::reference);
  evaluateCells(test, nodes, cells, &Cells::test);
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
    const OfPairs& weight = weights(record.weight);
    weightSum += (record.domain == MetricDomain::lab ? 1 : 3) * weight.sum;
    visitPower(record.power, [&](const auto& power) {
      const double *d = differences_.data(), *w = weight.columns.data();
      double* p = powers_.data();
      for (Eigen::Index i = 0; i < differences_.size(); ++i) p[i] = w[i] * power(d[i]);
    });
    deviation += powers_.sum();
  }

  Compared cells_;
  double gamma_;
  Array reference_, test_, differences_, powers_;
  std::array<std::optional<OfPairs>, 3> factors_, weights_;
};

Sums sumsOfBlock(std::span<const BrdfMetric> wanted, const HalfDifferenceGrid& grid, const Cells& cells, double gamma) {
  std::vector<double> measures(cells.indices.size());
  const auto rowLength = std::size_t(grid.phiDCount);
  std::size_t row = std::size_t(-1);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const std::size_t cell = cells.indices[i];
    // The same for all phi_d.
    measures[i] = cell / rowLength == row ? measures[i - 1] : grid.cellMeasure(cell);
    row = cell / rowLength;
  }
  return BlockSums({cells.pairs, cells.reference, cells.test, measures}, gamma).sum(wanted);
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

/// In the order of metricRecords(); 0 for metrics that are not wanted. @param cellsOf the cells of [begin, end).
template <typename CellsOf>
std::vector<double> errorsBy(std::span<const BrdfMetric> wanted, const HalfDifferenceGrid& grid, double gamma,
                             const CellsOf& cellsOf) {
  const std::size_t count = grid.size();
  std::vector<Sums> blocks((count + block - 1) / block);
  parallelForBlocks(count, block, [&](std::size_t begin, std::size_t end) {
    blocks[begin / block] = sumsOfBlock(wanted, grid, cellsOf(begin, end), gamma);
  });
  return errorsOf(blocks);
}

std::vector<double> errorsBy(std::span<const BrdfMetric> wanted, const Brdf& reference, const Brdf& test,
                             double maxPolarAngle, double gamma) {
  const Nodes nodes(reference, test);
  const double minCosine = smallestCosine(maxPolarAngle);
  return errorsBy(wanted, nodes.grid(), gamma, [&](std::size_t begin, std::size_t end) {
    return cellsOfBlock(reference, test, nodes, begin, end, minCosine);
  });
}

}  // namespace

double brdfError(BrdfMetric metric, const Brdf& reference, const Brdf& test, double maxPolarAngle, double gamma) {
  return errorsBy(std::span(&metric, 1), reference, test, maxPolarAngle, gamma)[static_cast<std::size_t>(metric)];
}

std::vector<double> brdfErrors(const Brdf& reference, const Brdf& test, double maxPolarAngle, double gamma) {
  return errorsBy(allBrdfMetrics(), reference, test, maxPolarAngle, gamma);
}

SampledReference::SampledReference(const Brdf& reference) : reference_(reference) {
  if (formOf<TabulatedBrdf>(reference) || !reference.isIsotropic()) return;
  const Nodes nodes(reference, reference);
  grid_ = nodes.grid();
  values_.resize(grid_.size());
  known_.resize(grid_.size());
  parallelForBlocks(grid_.size(), block, [&](std::size_t begin, std::size_t end) {
    Cells cells = directionsOfBlock(nodes, begin, end, 0);
    evaluateCells(reference, nodes, cells, &Cells::reference);
    for (std::size_t i = 0; i < cells.indices.size(); ++i) {
      values_[cells.indices[i]] = glm::vec3(cells.reference[i]);
      known_[cells.indices[i]] = 1;
    }
  });
}

std::vector<double> SampledReference::errors(const Brdf& test, double maxPolarAngle, double gamma) const {
  const Nodes nodes(reference_, test);
  if (values_.empty() || nodes.grid() != grid_ || !nodes.isIsotropic())
    return brdfErrors(reference_, test, maxPolarAngle, gamma);
  const double minCosine = smallestCosine(maxPolarAngle);
  return errorsBy(allBrdfMetrics(), grid_, gamma, [&](std::size_t begin, std::size_t end) {
    Cells cells = directionsOfBlock(nodes, begin, end, minCosine);
    std::vector<bool> known;
    for (const std::size_t cell : cells.indices) {
      cells.reference.push_back(Rgb(values_[cell]));
      known.push_back(known_[cell] != 0);
    }
    keepKnown(known, cells);
    evaluateCells(test, nodes, cells, &Cells::test);
    return cells;
  });
}

double brdfSignalToNoiseRatio(const Brdf& reference, const Brdf& test) {
  const Nodes nodes(reference, test);
  const std::size_t count = nodes.grid().size();
  std::vector<glm::dvec2> blocks((count + block - 1) / block, glm::dvec2(0));
  parallelForBlocks(count, block, [&](std::size_t begin, std::size_t end) {
    // Tables hold cells a little below the horizon as well: their cosine is 0.
    const Cells cells = cellsOfBlock(reference, test, nodes, begin, end, 0);
    for (std::size_t i = 0; i < cells.indices.size(); ++i) {
      const double cosines = cells.pairs[i].wi.z * cells.pairs[i].wo.z;
      const Rgb signal = cells.reference[i] * cosines, noise = signal - cells.test[i] * cosines;
      blocks[begin / block] += glm::dvec2(glm::dot(signal, signal), glm::dot(noise, noise));
    }
  });
  glm::dvec2 total(0);
  for (const glm::dvec2& sums : blocks) total += sums;
  return decibels(total.x, total.y);
}

}  // namespace gonio::metrics
