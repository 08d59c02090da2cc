// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/correlation.h"

namespace gonio::dictionary {

namespace {

/// The coefficients by their atom of one mode.
struct AtomGroups {
  std::vector<Eigen::Index> atoms;                ///< those with coefficients, rising
  std::vector<std::vector<std::size_t>> members;  ///< indices of the coefficients of each
};

std::array<Eigen::Index, 3> atomsOf(const Coefficient<double>& c, const ModeMatrices<double>& matrices) {
  const Eigen::Index n0 = matrices[0].cols(), n1 = matrices[1].cols(), index = c.index;
  return {index % n0, index / n0 % n1, index / (n0 * n1)};
}

AtomGroups groupsOf(std::span<const Coefficient<double>> coefficients, const ModeMatrices<double>& matrices,
                    std::size_t mode) {
  std::vector<std::vector<std::size_t>> members(std::size_t(matrices[mode].cols()));
  for (std::size_t n = 0; n < coefficients.size(); ++n)
    members[std::size_t(atomsOf(coefficients[n], matrices)[mode])].push_back(n);
  AtomGroups groups;
  for (std::size_t atom = 0; atom < members.size(); ++atom)
    if (!members[atom].empty()) {
      groups.atoms.push_back(Eigen::Index(atom));
      groups.members.push_back(std::move(members[atom]));
    }
  return groups;
}

}  // namespace

void addCorrelation(const double* block, const Sizes& sizes, const ModeMatrices<double>& matrices, int mode,
                    std::span<const Coefficient<double>> coefficients, Workspace<double>& workspace,
                    Eigen::MatrixXd& z) {
  const auto m = std::size_t(mode);
  std::size_t p = mode == 0 ? 1 : 0, q = 3 - m - p;
  AtomGroups groups = groupsOf(coefficients, matrices, p);
  if (AtomGroups other = groupsOf(coefficients, matrices, q); other.atoms.size() < groups.atoms.size()) {
    std::swap(p, q);
    groups = std::move(other);
  }

  const Matrix<double> atoms = matrices[p](Eigen::all, groups.atoms);
  Sizes projectedSizes = sizes;
  projectedSizes[p] = int(groups.atoms.size());
  workspace.first.resize(count(projectedSizes));
  transposedModeProduct(block, sizes, int(p), atoms, workspace.first.data());

  const std::array<Eigen::Index, 3> strides{1, projectedSizes[0], Eigen::Index(projectedSizes[0]) * projectedSizes[1]};
  using Slice = Eigen::Map<const Matrix<double>, 0, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>;
  Matrix<double> slice, weights, fibres;
  for (std::size_t g = 0; g < groups.members.size(); ++g) {
    const std::vector<std::size_t>& members = groups.members[g];
    slice = Slice(workspace.first.data() + Eigen::Index(g) * strides[p], sizes[m], sizes[q], {strides[q], strides[m]});
    weights.resize(sizes[q], Eigen::Index(members.size()));
    for (std::size_t n = 0; n < members.size(); ++n) {
      const Coefficient<double>& c = coefficients[members[n]];
      weights.col(Eigen::Index(n)) = c.value * matrices[q].col(atomsOf(c, matrices)[q]);
    }
    fibres.noalias() = slice * weights;
    for (std::size_t n = 0; n < members.size(); ++n)
      z.col(atomsOf(coefficients[members[n]], matrices)[m]) += fibres.col(Eigen::Index(n));
  }
}

}  // namespace gonio::dictionary
