// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <string>

#include "core/brdf/log_relative.h"
#include "core/coordinates/grid_directions.h"
#include "core/dictionary/principal_components.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

/// The fraction of the progress at which the materials are read, and at which they are mapped.
constexpr double readShare = 0.4, mappedShare = 0.5;
constexpr std::size_t blockCells = 1024;

/// The cells valid in a table and their weights.
MappedCells validCells(const TabulatedBrdf& table) {
  MappedCells result{.grid = table.grid()};
  const GridDirections directions(table.grid());
  for (std::size_t cell = 0; cell < table.valid().size(); ++cell) {
    if (!table.valid()[cell]) continue;
    const auto [pair, aboveHorizon] = directions.at(cell);
    result.cells.push_back(std::uint32_t(cell));
    result.weights.push_back(float(cosineWeight(std::max(0.0, pair.wi.z), std::max(0.0, pair.wo.z))));
  }
  return result;
}

/// rho w of a table's channels into three columns; cells that are not valid in it are marked.
void appendColumns(const TabulatedBrdf& table, const MappedCells& mapping, TallMatrix& columns,
                   std::vector<char>& missing) {
  const Eigen::Index first = columns.columns;
  columns.columns += 3;
  auto view = columns.view();
  for (std::size_t i = 0; i < mapping.cells.size(); ++i) {
    const std::size_t cell = mapping.cells[i];
    if (!table.valid()[cell]) missing[i] = 1;
    for (int channel = 0; channel < 3; ++channel)
      view(Eigen::Index(i), first + channel) = table.values()[cell][channel] * mapping.weights[i];
  }
}

/// Leaves out the rows that are marked.
void compact(MappedCells& mapping, TallMatrix& columns, const std::vector<char>& missing) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < missing.size(); ++i)
    if (!missing[i]) kept.push_back(i);
  if (kept.size() == missing.size()) return;
  for (std::size_t column = 0; column < std::size_t(columns.columns); ++column)
    for (std::size_t i = 0; i < kept.size(); ++i)
      columns.values[column * kept.size() + i] = columns.values[column * missing.size() + kept[i]];
  for (std::size_t i = 0; i < kept.size(); ++i) {
    mapping.cells[i] = mapping.cells[kept[i]];
    mapping.weights[i] = mapping.weights[kept[i]];
  }
  mapping.cells.resize(kept.size());
  mapping.weights.resize(kept.size());
  columns.rows = Eigen::Index(kept.size());
  columns.values.resize(kept.size() * std::size_t(columns.columns));
}

/// Maps all columns in place and takes their mean away.
std::vector<float> mapAndCentre(const MappedCells& mapping, TallMatrix& columns, const TaskControl& control) {
  std::vector<float> mean(mapping.cells.size());
  auto view = columns.view();
  parallelForBlocks(
      mean.size(), blockCells,
      [&](std::size_t begin, std::size_t end) {
        std::vector<double> sums(end - begin, 0.0);
        for (Eigen::Index column = 0; column < view.cols(); ++column)
          for (std::size_t i = begin; i < end; ++i) {
            float& value = view(Eigen::Index(i), column);
            value = float(logRelative(value, 1, mapping.reference[i]));
            sums[i - begin] += value;
          }
        for (std::size_t i = begin; i < end; ++i) mean[i] = float(sums[i - begin] / double(view.cols()));
        const auto first = Eigen::Index(begin), count = Eigen::Index(end - begin);
        view.middleRows(first, count).colwise() -=
            Eigen::Map<const Eigen::VectorXf>(mean.data(), Eigen::Index(mean.size())).segment(first, count);
      },
      control);
  return mean;
}

/// The variance of each row over the columns, of mean 0.
std::vector<float> rowVariance(const TallMatrix& columns) {
  std::vector<float> result(std::size_t(columns.rows));
  const auto view = columns.view();
  parallelForBlocks(result.size(), blockCells, [&](std::size_t begin, std::size_t end) {
    std::vector<double> sums(end - begin, 0.0);
    for (Eigen::Index column = 0; column < view.cols(); ++column)
      for (std::size_t i = begin; i < end; ++i) {
        const double value = view(Eigen::Index(i), column);
        sums[i - begin] += value * value;
      }
    for (std::size_t i = begin; i < end; ++i) result[i] = float(sums[i - begin] / double(view.cols()));
  });
  return result;
}

/// What the components that were kept do not explain of the variance.
std::vector<float> leftOutOf(const PrincipalComponents& pca, std::vector<float> variance) {
  parallelForBlocks(variance.size(), blockCells, [&](std::size_t begin, std::size_t end) {
    const std::vector<float> kept = leftOutVariance(pca, 0, begin, end);
    for (std::size_t i = begin; i < end; ++i) variance[i] = std::max(0.0f, variance[i] - kept[i - begin]);
  });
  return variance;
}

}  // namespace

PrincipalComponents learnPrincipalComponents(
    std::size_t materials, const std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)>& load,
    const PcaOptions& options, const TaskControl& control) {
  if (materials == 0) throw Error("principal components need at least one material");
  PrincipalComponents pca;
  TallMatrix columns;
  std::vector<char> missing;
  for (std::size_t material = 0; material < materials; ++material) {
    control.throwIfStopped();
    const auto table = load(material);
    if (material == 0) {
      pca.mapping = validCells(*table);
      missing.assign(pca.mapping.cells.size(), 0);
      columns.rows = Eigen::Index(missing.size());
      columns.values.resize(missing.size() * 3 * materials);
    }
    if (!(table->grid() == pca.mapping.grid))
      throw Error("material " + std::to_string(material) + " has a different grid from the first");
    appendColumns(*table, pca.mapping, columns, missing);
    control.report(readShare * double(material + 1) / double(materials));
  }
  compact(pca.mapping, columns, missing);
  if (pca.mapping.cells.empty()) throw Error("no cell is valid in all materials of the training set");

  std::vector<std::span<const float>> spans;
  for (std::size_t column = 0; column < std::size_t(columns.columns); ++column)
    spans.push_back(std::span(columns.values).subspan(column * pca.mapping.cells.size(), pca.mapping.cells.size()));
  pca.mapping.reference = medianReference(spans);
  pca.mean = mapAndCentre(pca.mapping, columns, control.between(readShare, mappedShare));
  std::vector<float> variance;
  if (options.maxComponents < columns.columns) variance = rowVariance(columns);
  pca.svd = decomposeGramSvd(std::move(columns), options.maxComponents, control.between(mappedShare, 1));
  if (!variance.empty()) pca.leftOut = leftOutOf(pca, std::move(variance));
  return pca;
}

}  // namespace gonio::dictionary
