// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/mapped_columns.h"

#include <algorithm>
#include <string>

#include "core/brdf/data_transform.h"
#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

constexpr std::size_t blockCells = 1024;

}  // namespace

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

void appendColumns(const TabulatedBrdf& table, const MappedCells& mapping, TallMatrix& columns,
                   std::vector<char>& missing) {
  if (!(table.grid() == mapping.grid))
    throw Error("a material of the training set has a different grid from the first");
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

std::vector<std::size_t> removeMarkedCells(MappedCells& mapping, const std::vector<char>& missing) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < missing.size(); ++i)
    if (!missing[i]) kept.push_back(i);
  if (kept.empty()) throw Error("no cell is valid in all materials of the training set");
  for (std::size_t i = 0; i < kept.size(); ++i) {
    mapping.cells[i] = mapping.cells[kept[i]];
    mapping.weights[i] = mapping.weights[kept[i]];
  }
  mapping.cells.resize(kept.size());
  mapping.weights.resize(kept.size());
  return kept;
}

void selectRows(TallMatrix& columns, std::span<const std::size_t> rows) {
  const auto before = std::size_t(columns.rows);
  if (rows.size() == before) return;
  for (std::size_t column = 0; column < std::size_t(columns.columns); ++column)
    for (std::size_t i = 0; i < rows.size(); ++i)
      columns.values[column * rows.size() + i] = columns.values[column * before + rows[i]];
  columns.rows = Eigen::Index(rows.size());
  columns.values.resize(rows.size() * std::size_t(columns.columns));
}

std::vector<float> rowMedians(const TallMatrix& columns) {
  const auto rows = std::size_t(columns.rows);
  std::vector<std::span<const float>> spans;
  for (std::size_t column = 0; column < std::size_t(columns.columns); ++column)
    spans.push_back(std::span(columns.values).subspan(column * rows, rows));
  return medianReference(spans);
}

std::vector<float> mapAndCentre(std::span<const float> reference, TallMatrix& columns, const TaskControl& control) {
  std::vector<float> mean(reference.size());
  auto view = columns.view();
  parallelForBlocks(
      mean.size(), blockCells,
      [&](std::size_t begin, std::size_t end) {
        std::vector<double> sums(end - begin, 0.0);
        for (Eigen::Index column = 0; column < view.cols(); ++column)
          for (std::size_t i = begin; i < end; ++i) {
            float& value = view(Eigen::Index(i), column);
            value = float(logRelative(value, 1, reference[i]));
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

std::vector<float> unexplainedVariance(const PrincipalComponents& pca, std::vector<float> variance) {
  parallelForBlocks(variance.size(), blockCells, [&](std::size_t begin, std::size_t end) {
    const std::vector<float> kept = leftOutVariance(pca, 0, begin, end);
    for (std::size_t i = begin; i < end; ++i) variance[i] = std::max(0.0f, variance[i] - kept[i - begin]);
  });
  return variance;
}

}  // namespace gonio::dictionary
