// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/learn_streamed_components.h"
#include "core/dictionary/mapped_columns.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

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
