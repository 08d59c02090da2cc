// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "core/brdf/data_transform.h"
#include "core/coordinates/grid_directions.h"
#include "core/dictionary/principal_components.h"
#include "core/io/atomic_file.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

// The steps, over all cells or over a block of them.

constexpr std::size_t blockCells = 1024;

/// The cells valid in a table and their weights; without a reference.
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

/// Appends rho w of a table's channels as three columns. Cells that are not valid in the table are marked in `missing`.
/// @throws Error if the table's grid is not that of the mapping.
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

/// Removes the marked cells from the mapping. @return the indices of those that remain.
/// @throws Error if none remains.
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

/// Removes all other rows, in place.
void selectRows(TallMatrix& columns, std::span<const std::size_t> rows) {
  const auto before = std::size_t(columns.rows);
  if (rows.size() == before) return;
  for (std::size_t column = 0; column < std::size_t(columns.columns); ++column)
    for (std::size_t i = 0; i < rows.size(); ++i)
      columns.values[column * rows.size() + i] = columns.values[column * before + rows[i]];
  columns.rows = Eigen::Index(rows.size());
  columns.values.resize(rows.size() * std::size_t(columns.columns));
}

/// The median of each row.
std::vector<float> rowMedians(const TallMatrix& columns) {
  const auto rows = std::size_t(columns.rows);
  std::vector<std::span<const float>> spans;
  for (std::size_t column = 0; column < std::size_t(columns.columns); ++column)
    spans.push_back(std::span(columns.values).subspan(column * rows, rows));
  return medianReference(spans);
}

/// Maps rho w to log-relative values in place and subtracts the mean of each row. @return the means.
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

/// The variance of each row over the columns. Precondition: the mean of each row is 0.
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

/// The part of the variance of each row that the components do not explain.
std::vector<float> unexplainedVariance(const PrincipalComponents& pca, std::vector<float> variance) {
  parallelForBlocks(variance.size(), blockCells, [&](std::size_t begin, std::size_t end) {
    const std::vector<float> kept = leftOutVariance(pca, 0, begin, end);
    for (std::size_t i = begin; i < end; ++i) variance[i] = std::max(0.0f, variance[i] - kept[i - begin]);
  });
  return variance;
}

/// The fractions of the progress at which the columns are written, and at which the Gram matrix is complete.
constexpr double writtenFraction = 0.3, gramFraction = 0.7;
constexpr std::uint64_t valueBytes = sizeof(float);

/// rho w of all cells of the first material, a column for each channel of each material.
struct ColumnFile {
  io::ScratchFile file;
  std::uint64_t cells, columns;

  ColumnFile(std::uint64_t cellCount, std::uint64_t columnCount)
      : file(std::filesystem::temp_directory_path(), cellCount * columnCount * valueBytes),
        cells(cellCount),
        columns(columnCount) {}

  void write(std::uint64_t first, const TallMatrix& values) { file.write(first * cells * valueBytes, values.values); }

  /// The rows of some cells, given by ascending indices.
  TallMatrix rows(std::span<const std::size_t> kept) const {
    const std::size_t begin = kept.front(), count = kept.back() + 1 - begin;
    TallMatrix result{
        .values = std::vector<float>(count * columns), .rows = Eigen::Index(count), .columns = Eigen::Index(columns)};
    for (std::uint64_t column = 0; column < columns; ++column)
      file.read((column * cells + begin) * valueBytes, std::span(result.values).subspan(column * count, count));
    std::vector<std::size_t> relative(kept.begin(), kept.end());
    for (std::size_t& row : relative) row -= begin;
    selectRows(result, relative);
    return result;
  }
};

/// So many that a block, and its copy in double precision, need half of the memory allowed.
std::size_t cellsPerBlock(const PcaOptions& options, std::uint64_t columns) {
  const std::uint64_t bytesOfCell = columns * (sizeof(float) + sizeof(double));
  return std::size_t(std::max<std::uint64_t>(1, options.maxBytes / 2 / bytesOfCell));
}

void checkComponents(std::uint64_t cells, std::uint64_t columns, const PcaOptions& options) {
  const std::uint64_t components = std::min(columns, std::uint64_t(std::max(0, options.maxComponents)));
  const std::uint64_t most = options.maxBytes / (cells * valueBytes);
  if (components > most)
    throw Error(std::to_string(components) + " principal components of " + std::to_string(cells) +
                " cells need more memory than the limit of " + std::to_string(options.maxBytes / 1'000'000) +
                " MB; ask for at most " + std::to_string(most) + " components");
}

/// Writes the columns of all materials. @return the cells of the mapping that are kept: those valid in all of them.
std::vector<std::size_t> fill(ColumnFile& file, MappedCells& mapping, const TabulatedBrdf& first,
                              const std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)>& load,
                              const TaskControl& control) {
  const std::size_t materials = std::size_t(file.columns) / 3;
  std::vector<char> missing(mapping.cells.size(), 0);
  for (std::size_t material = 0; material < materials; ++material) {
    control.throwIfStopped();
    TallMatrix three{.values = std::vector<float>(3 * missing.size()), .rows = Eigen::Index(missing.size())};
    appendColumns(material == 0 ? first : *load(material), mapping, three, missing);
    file.write(3 * material, three);
    control.report(double(material + 1) / double(materials));
  }
  return removeMarkedCells(mapping, missing);
}

/// learnPrincipalComponents() with the columns in a temporary file: each block of cells is read twice, for the Gram
/// matrix and for the components. @param first the table of material 0.
PrincipalComponents learnStreamedComponents(
    const TabulatedBrdf& first, std::size_t materials,
    const std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)>& load, const PcaOptions& options,
    const TaskControl& control) {
  PrincipalComponents pca;
  pca.mapping = validCells(first);
  const std::uint64_t columns = 3 * materials;
  checkComponents(pca.mapping.cells.size(), columns, options);
  ColumnFile file(pca.mapping.cells.size(), columns);
  const std::vector<std::size_t> kept = fill(file, pca.mapping, first, load, control.between(0, writtenFraction));
  const std::size_t blockSize = cellsPerBlock(options, columns);
  const auto forEachBlock = [&](const TaskControl& part, const auto& work) {
    for (std::size_t begin = 0; begin < kept.size(); begin += blockSize) {
      part.throwIfStopped();
      const std::size_t count = std::min(blockSize, kept.size() - begin);
      work(begin, count, file.rows(std::span(kept).subspan(begin, count)));
      part.report(double(begin + count) / double(kept.size()));
    }
  };

  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(Eigen::Index(columns), Eigen::Index(columns));
  std::vector<float> variance;
  forEachBlock(control.between(writtenFraction, gramFraction), [&](std::size_t, std::size_t, TallMatrix block) {
    const std::vector<float> medians = rowMedians(block);
    const std::vector<float> means = mapAndCentre(medians, block, {});
    const std::vector<float> variances = rowVariance(block);
    pca.mapping.reference.insert(pca.mapping.reference.end(), medians.begin(), medians.end());
    pca.mean.insert(pca.mean.end(), means.begin(), means.end());
    variance.insert(variance.end(), variances.begin(), variances.end());
    addToGram(gram, block);
  });

  pca.svd = decomposeGram(gram, options.maxComponents);
  TallMatrix& u = pca.svd.u;
  u.rows = Eigen::Index(kept.size());
  u.columns = pca.svd.singularValues.size();
  u.values.resize(kept.size() * std::size_t(u.columns));
  forEachBlock(control.between(gramFraction, 1), [&](std::size_t begin, std::size_t count, TallMatrix block) {
    mapAndCentre(std::span(pca.mapping.reference).subspan(begin, count), block, {});
    u.view().middleRows(Eigen::Index(begin), Eigen::Index(count)) = leftVectors(pca.svd, block);
  });
  if (std::uint64_t(std::max(0, options.maxComponents)) < columns)
    pca.leftOut = unexplainedVariance(pca, std::move(variance));
  return pca;
}

/// The fraction of the progress at which the materials are read, and at which they are mapped.
constexpr double readFraction = 0.4, mappedFraction = 0.5;

}  // namespace

PrincipalComponents learnPrincipalComponents(
    std::size_t materials, const std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)>& load,
    const PcaOptions& options, const TaskControl& control) {
  if (materials == 0) throw Error("principal components need at least one material");
  auto table = load(0);
  PrincipalComponents pca;
  pca.mapping = validCells(*table);
  const std::uint64_t values = std::uint64_t(pca.mapping.cells.size()) * 3 * materials;
  if (values * sizeof(float) > options.maxBytes)
    return learnStreamedComponents(*table, materials, load, options, control);

  TallMatrix columns{.values = std::vector<float>(values), .rows = Eigen::Index(pca.mapping.cells.size())};
  std::vector<char> missing(pca.mapping.cells.size(), 0);
  for (std::size_t material = 0; material < materials; ++material) {
    control.throwIfStopped();
    if (material > 0) table = load(material);
    appendColumns(*table, pca.mapping, columns, missing);
    control.report(readFraction * double(material + 1) / double(materials));
  }
  selectRows(columns, removeMarkedCells(pca.mapping, missing));
  pca.mapping.reference = rowMedians(columns);
  pca.mean = mapAndCentre(pca.mapping.reference, columns, control.between(readFraction, mappedFraction));
  std::vector<float> variance;
  if (options.maxComponents < columns.columns) variance = rowVariance(columns);
  pca.svd = decomposeGramSvd(std::move(columns), options.maxComponents, control.between(mappedFraction, 1));
  if (!variance.empty()) pca.leftOut = unexplainedVariance(pca, std::move(variance));
  return pca;
}

}  // namespace gonio::dictionary
