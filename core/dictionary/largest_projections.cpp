// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/largest_projections.h"

#include <numeric>

namespace gonio::dictionary {

namespace {

/// What rounding may add to a coefficient over the norm of what it is projected from.
constexpr float rounding = 1.001f;

/// The columns in falling order of their norms.
template <typename Norms>
std::vector<Eigen::Index> byNorm(const Norms& norms) {
  std::vector<Eigen::Index> order(std::size_t(norms.size()));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  std::ranges::stable_sort(order, [&](Eigen::Index a, Eigen::Index b) { return norms[a] > norms[b]; });
  return order;
}

}  // namespace

template <typename Scalar>
void selectLargestProjections(const Scalar* signal, const Sizes& sizes, const ModeMatrices<Scalar>& matrices,
                              std::size_t count, Workspace<Scalar>& workspace,
                              std::vector<Coefficient<Scalar>>& selected) {
  selected.clear();
  if (count == 0) return;
  workspace.first.resize(std::size_t(sizes[0]) * std::size_t(sizes[1]) * std::size_t(matrices[2].cols()));
  transposedModeProduct(signal, sizes, 2, matrices[2], workspace.first.data());
  selectLargestOfSlices(workspace.first.data(), sizes, matrices, count, selected);
}

template <typename Scalar>
void selectLargestOfSlices(const Scalar* projected2, const Sizes& sizes, const ModeMatrices<Scalar>& matrices,
                           std::size_t count, std::vector<Coefficient<Scalar>>& selected) {
  selected.clear();
  if (count == 0) return;
  using Map = Eigen::Map<const Matrix<Scalar>>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  const Eigen::Index n0 = sizes[0], n1 = sizes[1];
  const Eigen::Index slices = matrices[2].cols(), fibres = matrices[1].cols(), coefficients = matrices[0].cols();
  const Vector sliceNorms = Scalar(rounding) * Map(projected2, n0 * n1, slices).colwise().norm();

  LargestCoefficients<Scalar> largest(selected, count);
  Matrix<Scalar> projected(n0, fibres), chosen(n0, fibres), values(coefficients, fibres);
  for (const Eigen::Index slice : byNorm(sliceNorms)) {
    if (sliceNorms[slice] < largest.threshold()) break;
    projected.noalias() = Map(projected2 + n0 * n1 * slice, n0, n1) * matrices[1];
    const Vector fibreNorms = Scalar(rounding) * projected.colwise().norm();
    std::vector<Eigen::Index> large;
    for (Eigen::Index fibre = 0; fibre < fibres; ++fibre)
      if (fibreNorms[fibre] >= largest.threshold()) {
        chosen.col(Eigen::Index(large.size())) = projected.col(fibre);
        large.push_back(fibre);
      }
    const auto found = Eigen::Index(large.size());
    values.leftCols(found).noalias() = matrices[0].transpose() * chosen.leftCols(found);
    for (Eigen::Index n = 0; n < found; ++n)
      largest.add({values.col(n).data(), std::size_t(coefficients)},
                  std::size_t(coefficients * (large[std::size_t(n)] + fibres * slice)));
  }
  largest.prune();
}

template void selectLargestProjections(const float*, const Sizes&, const ModeMatrices<float>&, std::size_t,
                                       Workspace<float>&, std::vector<Coefficient<float>>&);
template void selectLargestProjections(const double*, const Sizes&, const ModeMatrices<double>&, std::size_t,
                                       Workspace<double>&, std::vector<Coefficient<double>>&);
template void selectLargestOfSlices(const float*, const Sizes&, const ModeMatrices<float>&, std::size_t,
                                    std::vector<Coefficient<float>>&);
template void selectLargestOfSlices(const double*, const Sizes&, const ModeMatrices<double>&, std::size_t,
                                    std::vector<Coefficient<double>>&);

}  // namespace gonio::dictionary
