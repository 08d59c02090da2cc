// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/cell_atoms.h"

#include <utility>

namespace gonio::acquisition {

CellAtoms::CellAtoms(const dictionary::PrincipalComponents& basis, int components, std::vector<std::size_t> rows)
    : basis_(basis),
      inverseSigma_(basis.svd.singularValues[components - 1] *
                    basis.svd.singularValues.head(components).cwiseInverse()),
      rows_(std::move(rows)) {}

Eigen::VectorXd CellAtoms::column(std::size_t row) const {
  return basis_.svd.u.view()
      .row(Eigen::Index(row))
      .head(length())
      .transpose()
      .cast<double>()
      .cwiseProduct(inverseSigma_);
}

Eigen::MatrixXf CellAtoms::inSinglePrecision(Eigen::Index begin, Eigen::Index end) const {
  const auto u = basis_.svd.u.view();
  constexpr float shortest = 1e-15f;
  Eigen::MatrixXf atoms(length(), end - begin);
  for (Eigen::Index k = 0; k < length(); ++k)
    for (Eigen::Index atom = begin; atom < end; ++atom)
      atoms(k, atom - begin) = float(u(Eigen::Index(row(atom)), k) * inverseSigma_[k]);
  for (Eigen::Index atom = begin; atom < end; ++atom) {
    auto column = atoms.col(atom - begin);
    const float norm = column.norm();
    // Below this digits are lost; 0 stays 0.
    if (norm > shortest)
      column /= norm;
    else
      column = exact(atom).cast<float>();
  }
  return atoms;
}

}  // namespace gonio::acquisition
