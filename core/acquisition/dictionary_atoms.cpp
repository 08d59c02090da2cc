// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/dictionary_atoms.h"

#include <cmath>

#include "core/math/parallel.h"

namespace gonio::acquisition {

namespace {

constexpr std::size_t blockAtoms = 4096;
constexpr float shortest = 1e-15f;

}  // namespace

DictionaryAtoms::DictionaryAtoms(const dictionary::PrincipalComponents& basis, int components,
                                 const std::vector<std::size_t>& rows)
    : basis_(basis),
      inverseSigma_(basis.svd.singularValues[components - 1] *
                    basis.svd.singularValues.head(components).cwiseInverse()),
      rows_(rows) {
  std::vector<char> usable(rows_.size());
  parallelForBlocks(rows_.size(), blockAtoms, [&](std::size_t begin, std::size_t end) {
    const auto u = basis_.svd.u.view();
    for (Eigen::Index k = 0; k < length(); ++k)
      for (std::size_t atom = begin; atom < end; ++atom) usable[atom] |= u(Eigen::Index(rows_[atom]), k) != 0;
  });
  std::size_t kept = 0;
  for (std::size_t atom = 0; atom < rows_.size(); ++atom)
    if (usable[atom]) rows_[kept++] = rows_[atom];
  rows_.resize(kept);
}

Eigen::VectorXd DictionaryAtoms::column(std::size_t row) const {
  return basis_.svd.u.view()
      .row(Eigen::Index(row))
      .head(length())
      .transpose()
      .cast<double>()
      .cwiseProduct(inverseSigma_);
}

Eigen::MatrixXf DictionaryAtoms::inSinglePrecision(Eigen::Index begin, Eigen::Index end) const {
  const auto u = basis_.svd.u.view();
  Eigen::MatrixXf atoms(length(), end - begin);
  for (Eigen::Index k = 0; k < length(); ++k)
    for (Eigen::Index atom = begin; atom < end; ++atom)
      atoms(k, atom - begin) = float(u(Eigen::Index(row(atom)), k) * inverseSigma_[k]);
  for (Eigen::Index atom = begin; atom < end; ++atom) {
    auto column = atoms.col(atom - begin);
    const float norm = column.norm();
    // The shortest have lost digits.
    if (norm > shortest)
      column /= norm;
    else
      column = exact(atom).cast<float>();
  }
  return atoms;
}

}  // namespace gonio::acquisition
