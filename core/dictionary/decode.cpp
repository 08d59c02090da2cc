// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/decode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/brdf/value_bound.h"
#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_difference_grid.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

/// The channels, the fourth unused, at one node of mode 0 and at the next one.
using Lanes = Eigen::Array<float, 8, 1>;

/// The channels, the fourth unused, at the corners of a cell in the order of GridCorners: its bits belong to the modes.
using CornerValues = Eigen::Array<float, 4, 8>;

/// The atoms of one mode that are used, those of a node side by side.
class Atoms {
 public:
  Atoms(const Eigen::MatrixXd& mode, const std::vector<int>& used) : count_(used.size()) {
    values_.resize(std::size_t(mode.rows()) * count_);
    for (Eigen::Index node = 0; node < mode.rows(); ++node)
      for (std::size_t a = 0; a < count_; ++a) values_[std::size_t(node) * count_ + a] = float(mode(node, used[a]));
  }

  /// All atoms at a node.
  const float* at(int node) const { return values_.data() + std::size_t(node) * count_; }
  std::size_t count() const { return count_; }

 private:
  std::size_t count_;
  std::vector<float> values_;
};

/// Numbers the atoms of a mode in the order in which they are asked for.
class UsedAtoms {
 public:
  std::uint16_t place(std::uint32_t atom) {
    const auto [found, isNew] = places_.try_emplace(atom, std::uint16_t(list_.size()));
    if (isNew) list_.push_back(int(atom));
    return found->second;
  }
  const std::vector<int>& list() const { return list_; }

 private:
  std::map<std::uint32_t, std::uint16_t> places_;
  std::vector<int> list_;
};

/// The coefficients of all channels of one dictionary, by the atoms of mode 2, then of mode 1, so that each costs one
/// product per node of mode 0.
class DictionarySum {
 public:
  /// @param channels of the code that have this dictionary.
  DictionarySum(const std::array<Eigen::MatrixXd, 3>& atoms, const SparseCode& code, const std::vector<int>& channels) {
    std::map<std::uint32_t, Lanes> byIndex;
    for (const int channel : channels)
      for (const Coefficient<float>& c : code.channels[std::size_t(channel)].coefficients) {
        Lanes& lanes = byIndex.try_emplace(c.index, Lanes::Zero()).first->second;
        lanes[channel] += c.value;
        lanes[channel + 4] += c.value;
      }
    const auto n0 = std::uint32_t(atoms[0].rows()), n1 = std::uint32_t(atoms[1].rows());
    std::array<UsedAtoms, 3> used;
    for (const auto& [index, lanes] : byIndex) {
      const std::uint16_t atom1 = used[1].place(index / n0 % n1), atom2 = used[2].place(index / (n0 * n1));
      const bool startsSlice = slices_.empty() || slices_.back().atom != atom2;
      if (startsSlice) slices_.push_back({atom2, 0});
      if (startsSlice || rows_.back().atom != atom1) rows_.push_back({atom1, 0});
      slices_.back().end = std::uint32_t(rows_.size());
      atoms0_.push_back(used[0].place(index % n0));
      values_.push_back(lanes);
      rows_.back().end = std::uint32_t(values_.size());
    }
    for (std::size_t mode = 0; mode < 3; ++mode) atoms_.emplace_back(atoms[mode], used[mode].list());
  }

  /// @param scratch for the atoms of mode 0 at both nodes.
  void addTo(CornerValues& corners, const GridCorners& at, std::vector<Lanes>& scratch) const {
    scratch.resize(atoms_[0].count());
    const float *const low0 = atoms_[0].at(at.phiD.low), *const high0 = atoms_[0].at(at.phiD.high);
    for (std::size_t a = 0; a < scratch.size(); ++a)
      scratch[a] << low0[a], low0[a], low0[a], low0[a], high0[a], high0[a], high0[a], high0[a];
    const float *const low1 = atoms_[1].at(at.thetaD.low), *const high1 = atoms_[1].at(at.thetaD.high);
    const float *const low2 = atoms_[2].at(at.thetaH.low), *const high2 = atoms_[2].at(at.thetaH.high);
    std::array<Lanes, 4> sums{Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};  // by modes 1 and 2
    std::uint32_t row = 0, coefficient = 0;
    for (const Range& slice : slices_) {
      Lanes first = Lanes::Zero(), second = Lanes::Zero();  // by mode 1
      for (; row < slice.end; ++row) {
        Lanes sum = Lanes::Zero();
        for (; coefficient < rows_[row].end; ++coefficient) sum += values_[coefficient] * scratch[atoms0_[coefficient]];
        first += sum * low1[rows_[row].atom];
        second += sum * high1[rows_[row].atom];
      }
      sums[0] += first * low2[slice.atom];
      sums[1] += second * low2[slice.atom];
      sums[2] += first * high2[slice.atom];
      sums[3] += second * high2[slice.atom];
    }
    for (int k = 0; k < 4; ++k) {
      corners.col(2 * k) += sums[std::size_t(k)].head<4>();
      corners.col(2 * k + 1) += sums[std::size_t(k)].tail<4>();
    }
  }

 private:
  /// What follows the range before, up to `end`, and belongs to one atom.
  struct Range {
    std::uint16_t atom;
    std::uint32_t end;
  };
  std::vector<Atoms> atoms_;
  std::vector<Range> slices_, rows_;  ///< of rows_, by mode 2; of values_, by mode 1
  std::vector<std::uint16_t> atoms0_;
  std::vector<Lanes> values_;
};

class CodeBrdf final : public Brdf {
 public:
  CodeBrdf(const Ensemble& ensemble, const SparseCode& code)
      : grid_(code.grid), transform_(code.transform), geometry_(GridGeometry::of(code.grid)) {
    checkCode(ensemble, code);
    std::map<int, std::vector<int>> channels;
    for (int c = 0; c < 3; ++c) {
      channels[code.channels[std::size_t(c)].dictionary].push_back(c);
      highest_[c] = code.channels[std::size_t(c)].highest;
      lowest_[c] = code.channels[std::size_t(c)].lowest;
      largest_[c] = code.channels[std::size_t(c)].largestValue;
    }
    for (const auto& [dictionary, list] : channels)
      sums_.emplace_back(
          unscaledAtoms(dictionaryOf(ensemble, code, std::size_t(list.front())), *geometry_, code.scaled), code, list);
  }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    std::vector<Lanes> scratch;
    HalfDifferenceBlock block;
    for (std::size_t begin = 0; begin < pairs.size(); begin += HalfDifferenceBlock::capacity) {
      const std::size_t length = std::min(HalfDifferenceBlock::capacity, pairs.size() - begin);
      toHalfDifference(pairs.subspan(begin, length), block);
      for (std::size_t i = 0; i < length; ++i)
        values[begin + i] =
            block.valid[i] != 0 && isAboveHorizon(pairs[begin + i]) ? valueAt(block, i, scratch) : Rgb(0);
    }
  }
  bool isReciprocal() const override { return grid_.reciprocal; }
  /// From the values at all nodes: about 0.3 s for a MERL grid at the first call.
  std::shared_ptr<const ValueBound> valueBound() const override {
    std::call_once(boundOnce_, [this] { bound_ = boundOfNodes(); });
    return bound_;
  }

 private:
  std::shared_ptr<const ValueBound> boundOfNodes() const {
    std::vector<TabulatedBrdf::Value> values(grid_.size());
    std::vector<std::uint8_t> valid(grid_.size(), 0);
    const auto rows = std::size_t(grid_.thetaHCount);
    parallelForBlocks(rows, 1, [&](std::size_t begin, std::size_t end) {
      std::vector<Lanes> scratch;
      const std::size_t perRow = grid_.size() / rows;
      for (std::size_t cell = begin * perRow; cell < end * perRow; ++cell) {
        if (geometry_->aboveHorizon[cell] == 0) continue;
        const auto phi = std::size_t(grid_.phiDCount), thetaD = std::size_t(grid_.thetaDCount);
        const std::size_t row = cell / (phi * thetaD), column = cell / phi % thetaD;
        const GridCorners at(grid_, {double(row), double(column), double(cell % phi)});
        values[cell] = TabulatedBrdf::Value(glm::min(valueAt(at, scratch), Rgb(std::numeric_limits<float>::max())));
        valid[cell] = 1;
      }
    });
    return TabulatedBrdf(grid_, std::move(values), std::move(valid), NegativeValues::stay).valueBound();
  }

  static bool isAboveHorizon(const DirectionPair& pair) { return !isBelowHorizon(pair.wi) && !isBelowHorizon(pair.wo); }

  Rgb valueAt(const HalfDifferenceBlock& block, std::size_t i, std::vector<Lanes>& scratch) const {
    return valueAt(GridCorners(grid_, grid_.position(block.thetaH[i], block.thetaD[i], block.phiD[i])), scratch);
  }

  Rgb valueAt(const GridCorners& at, std::vector<Lanes>& scratch) const {
    CornerValues values = CornerValues::Zero(), cosines = CornerValues::Ones();
    for (const DictionarySum& sum : sums_) sum.addTo(values, at, scratch);
    values = values.min(highest_.replicate<1, 8>()).max(lowest_.replicate<1, 8>());
    if (transform_ == DataTransform::cosineLog)
      for (int corner = 0; corner < 8; ++corner)
        cosines.col(corner).setConstant(geometry_->weights[Eigen::Index(at.cell(corner))]);
    invertTransform(values.reshaped(), transform_, cosines.reshaped(), lowest_.minCoeff());
    values = values.min(largest_.replicate<1, 8>()).max(-largest_.replicate<1, 8>());
    Rgb sum(0);
    double weightSum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const double weight = geometry_->aboveHorizon[at.cell(corner)] != 0 ? at.weight(corner) : 0;
      for (int c = 0; c < 3; ++c) sum[c] += weight * double(values(c, corner));
      weightSum += weight;
    }
    return weightSum > 0 ? sum / weightSum : Rgb(0);
  }

  HalfDifferenceGrid grid_;
  DataTransform transform_;
  std::shared_ptr<const GridGeometry> geometry_;
  Eigen::Array<float, 4, 1> highest_ = Eigen::Array<float, 4, 1>::Zero(), lowest_ = highest_, largest_ = highest_;
  std::vector<DictionarySum> sums_;
  mutable std::once_flag boundOnce_;
  mutable std::shared_ptr<const ValueBound> bound_;
};

}  // namespace

std::unique_ptr<const Brdf> makeCodeBrdf(const Ensemble& ensemble, const SparseCode& code) {
  return std::make_unique<CodeBrdf>(ensemble, code);
}

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
  if (!(code.grid == ensemble.grid || code.grid == ensemble.grid.wholeCircle()))
    throw Error("the code and the dictionary have different grids");
  const std::size_t cells = code.grid.size();
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
    const auto atoms = unscaledAtoms(dictionaryOf(ensemble, code, c), *geometry, code.scaled);
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
      invertTransform(part, code.transform, geometry->weights.segment(first, length),
                      code.channels[std::size_t(c)].lowest);
      const double largest = code.channels[std::size_t(c)].largestValue;
      part = part.min(largest).max(-largest);
      for (Eigen::Index i = 0; i < length; ++i) values[begin + std::size_t(i)][c] = float(part[i]);
    }
  });
  return std::make_shared<const TabulatedBrdf>(code.grid, std::move(values), geometry->aboveHorizon,
                                               NegativeValues::stay);
}

}  // namespace gonio::dictionary
