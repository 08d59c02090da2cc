// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/decode.h"

#include <algorithm>
#include <string>

#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

/// A range of coefficients that share an atom.
template <typename Scalar, typename Atom>
std::size_t endOfGroup(const std::vector<Coefficient<Scalar>>& coefficients, std::size_t begin, const Atom& atom) {
  std::size_t end = begin + 1;
  while (end < coefficients.size() && atom(coefficients[end]) == atom(coefficients[begin])) ++end;
  return end;
}

}  // namespace

template <typename Scalar>
ComposedSlabs<Scalar> composeSlabs(const ModeMatrices<Scalar>& matrices,
                                   std::vector<Coefficient<Scalar>> coefficients) {
  const Eigen::Index n0 = matrices[0].rows(), n1 = matrices[1].rows(), n2 = matrices[2].rows();
  std::sort(coefficients.begin(), coefficients.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  const auto atom1 = [&](const Coefficient<Scalar>& c) { return Eigen::Index(c.index) / n0; };  // with that of mode 2
  const auto atom2 = [&](const Coefficient<Scalar>& c) { return Eigen::Index(c.index) / (n0 * n1); };
  std::vector<Eigen::Index> atoms2;
  for (std::size_t i = 0; i < coefficients.size(); i = endOfGroup(coefficients, i, atom2))
    atoms2.push_back(atom2(coefficients[i]));
  const Eigen::Index slabCount = Eigen::Index(atoms2.size());
  ComposedSlabs<Scalar> result{Matrix<Scalar>(n0 * n1, slabCount), Matrix<Scalar>(slabCount, n2)};
  Matrix<Scalar> fibres(n0, n1), partners(n1, n1);
  for (std::size_t begin = 0, slab = 0; begin < coefficients.size(); ++slab) {
    const std::size_t end = endOfGroup(coefficients, begin, atom2);
    Eigen::Index used = 0;
    while (begin < end) {
      const std::size_t groupEnd = endOfGroup(coefficients, begin, atom1);
      partners.col(used) = matrices[1].col(atom1(coefficients[begin]) % n1);
      fibres.col(used).setZero();
      for (; begin < groupEnd; ++begin)
        fibres.col(used) += coefficients[begin].value * matrices[0].col(Eigen::Index(coefficients[begin].index) % n0);
      ++used;
    }
    Eigen::Map<Matrix<Scalar>>(result.slabs.col(Eigen::Index(slab)).data(), n0, n1).noalias() =
        fibres.leftCols(used) * partners.leftCols(used).transpose();
    result.atoms.row(Eigen::Index(slab)) = matrices[2].col(atoms2[slab]).transpose();
  }
  return result;
}

template <typename Scalar>
void compose(const ModeMatrices<Scalar>& matrices, std::vector<Coefficient<Scalar>> coefficients, Scalar* block) {
  const ComposedSlabs<Scalar> composed = composeSlabs(matrices, std::move(coefficients));
  Eigen::Map<Matrix<Scalar>>(block, composed.slabs.rows(), composed.atoms.cols()).noalias() =
      composed.slabs * composed.atoms;
}

template ComposedSlabs<float> composeSlabs<float>(const ModeMatrices<float>&, std::vector<Coefficient<float>>);
template ComposedSlabs<double> composeSlabs<double>(const ModeMatrices<double>&, std::vector<Coefficient<double>>);
template void compose<float>(const ModeMatrices<float>&, std::vector<Coefficient<float>>, float*);
template void compose<double>(const ModeMatrices<double>&, std::vector<Coefficient<double>>, double*);

std::array<Eigen::MatrixXd, 3> unscaledAtoms(const Dictionary& dictionary, const GridGeometry& geometry, bool scaled) {
  if (!scaled) return dictionary.modes;
  std::array<Eigen::MatrixXd, 3> atoms;
  for (std::size_t mode = 0; mode < 3; ++mode)
    atoms[mode] = dictionary.modes[mode].array().colwise() / geometry.cellScaling[mode];
  return atoms;
}

void checkCode(const Ensemble& ensemble, const SparseCode& code) {
  if (!(code.grid == ensemble.grid)) throw Error("the code and the dictionary have different grids");
  const std::size_t cells = ensemble.grid.size();
  for (const ChannelCode& channel : code.channels) {
    if (channel.dictionary < 0 || std::size_t(channel.dictionary) >= ensemble.dictionaries.size())
      throw Error("the code refers to dictionary " + std::to_string(channel.dictionary) + ", expected 0 to " +
                  std::to_string(int(ensemble.dictionaries.size()) - 1));
    for (const Coefficient<float>& c : channel.coefficients)
      if (c.index >= cells)
        throw Error("a coefficient of the code has the index " + std::to_string(c.index) + ", expected less than " +
                    std::to_string(cells));
  }
}

std::array<Eigen::ArrayXd, 3> decodeSignals(const Ensemble& ensemble, const SparseCode& code) {
  checkCode(ensemble, code);
  const auto geometry = GridGeometry::of(code.grid);
  std::array<Eigen::ArrayXd, 3> signals;
  parallelForBlocks(3, 1, [&](std::size_t c, std::size_t) {
    const ChannelCode& channel = code.channels[c];
    const auto atoms = unscaledAtoms(ensemble.dictionaries[std::size_t(channel.dictionary)], *geometry, code.scaled);
    signals[c].resize(Eigen::Index(code.grid.size()));
    compose<double>(atoms, coefficientsIn<double>(channel.coefficients), signals[c].data());
    signals[c] = signals[c].min(double(channel.highest));
  });
  return signals;
}

std::shared_ptr<const TabulatedBrdf> decode(const Ensemble& ensemble, const SparseCode& code) {
  std::array<Eigen::ArrayXd, 3> signals = decodeSignals(ensemble, code);
  const auto geometry = GridGeometry::of(code.grid);
  std::vector<TabulatedBrdf::Value> values(code.grid.size());
  constexpr std::size_t block = 1 << 13;
  parallelForBlocks(values.size(), block, [&](std::size_t begin, std::size_t end) {
    const Eigen::Index first = Eigen::Index(begin), length = Eigen::Index(end - begin);
    for (int c = 0; c < 3; ++c) {
      auto part = signals[std::size_t(c)].segment(first, length);
      invertTransform(part, code.transform, geometry->weights.segment(first, length));
      for (Eigen::Index i = 0; i < length; ++i) values[begin + std::size_t(i)][c] = float(part[i]);
    }
  });
  return std::make_shared<const TabulatedBrdf>(code.grid, std::move(values), geometry->aboveHorizon);
}

}  // namespace gonio::dictionary
