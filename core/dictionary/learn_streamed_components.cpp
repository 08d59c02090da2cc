// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/learn_streamed_components.h"

#include <algorithm>
#include <string>

#include "core/dictionary/mapped_columns.h"
#include "core/io/atomic_file.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

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

}  // namespace

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
  const std::size_t blockCells = cellsPerBlock(options, columns);
  const auto forEachBlock = [&](const TaskControl& part, const auto& work) {
    for (std::size_t begin = 0; begin < kept.size(); begin += blockCells) {
      part.throwIfStopped();
      const std::size_t count = std::min(blockCells, kept.size() - begin);
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

}  // namespace gonio::dictionary
