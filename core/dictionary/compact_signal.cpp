// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/compact_signal.h"

#include "core/dictionary/gram.h"
#include "core/dictionary/largest_projections.h"
#include "core/math/decompositions.h"

namespace gonio::dictionary {

template <typename Scalar>
ModeMatrices<Scalar> CompactSignal<Scalar>::inBases(const ModeMatrices<Scalar>& dictionary) const {
  ModeMatrices<Scalar> result;
  for (std::size_t mode = 0; mode < 3; ++mode) result[mode].noalias() = bases[mode].transpose() * dictionary[mode];
  return result;
}

template <typename Scalar>
void CompactSignal<Scalar>::selectLargest(const ModeMatrices<Scalar>& dictionary, std::size_t count,
                                          Workspace<Scalar>& workspace,
                                          std::vector<Coefficient<Scalar>>& selected) const {
  selectLargestProjections(block.data(), ranks, inBases(dictionary), count, workspace, selected);
}

template <typename Scalar>
CompactSignal<Scalar> compactSignal(const Scalar* signal, const Sizes& sizes, double maxLoss) {
  CompactSignal<Scalar> result;
  using Values = Eigen::Map<const Eigen::Array<Scalar, Eigen::Dynamic, 1>>;
  result.energy = Values(signal, Eigen::Index(count(sizes))).template cast<double>().square().sum();
  for (int mode = 0; mode < 3; ++mode) {
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(sizes[std::size_t(mode)], sizes[std::size_t(mode)]);
    addGram(signal, sizes, mode, gram);
    const EigenBasis basis = eigenBasis(gram);
    const int rank = rankFor(basis.values, maxLoss / 3);
    result.bases[std::size_t(mode)] = basis.vectors.leftCols(rank).template cast<Scalar>();
    result.ranks[std::size_t(mode)] = rank;
  }
  Workspace<Scalar> workspace;
  const Scalar* block = transposedModeProducts(signal, sizes, result.bases, workspace);
  result.block.assign(block, block + count(result.ranks));
  return result;
}

template struct CompactSignal<float>;
template struct CompactSignal<double>;
template CompactSignal<float> compactSignal(const float*, const Sizes&, double);
template CompactSignal<double> compactSignal(const double*, const Sizes&, double);

}  // namespace gonio::dictionary
