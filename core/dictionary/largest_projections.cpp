// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/largest_projections.h"

#include <numeric>

#include "core/dictionary/mode_products.h"
#include "core/math/decompositions.h"

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

void keepLargest(std::span<std::vector<Coefficient<double>>> parts, std::size_t count) {
  if (parts.size() < 2) return;
  struct Entry {
    std::size_t part;
    Coefficient<double> coefficient;
  };
  std::vector<Entry> all;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (const Coefficient<double>& c : parts[part]) all.push_back({part, c});
    parts[part].clear();
  }
  if (count < all.size()) {
    std::nth_element(all.begin(), all.begin() + std::ptrdiff_t(count), all.end(), [](const Entry& a, const Entry& b) {
      const double sizeA = std::abs(a.coefficient.value), sizeB = std::abs(b.coefficient.value);
      return sizeA == sizeB && a.part != b.part ? a.part < b.part : isLarger(a.coefficient, b.coefficient);
    });
    all.resize(count);
  }
  for (const Entry& entry : all) parts[entry.part].push_back(entry.coefficient);
}

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
