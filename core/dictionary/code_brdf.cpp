// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_brdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_difference_grid.h"
#include "core/dictionary/decode.h"

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
    }
    for (const auto& [dictionary, list] : channels)
      sums_.emplace_back(unscaledAtoms(ensemble.dictionaries[std::size_t(dictionary)], *geometry_, code.scaled), code,
                         list);
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

 private:
  static bool isAboveHorizon(const DirectionPair& pair) { return !isBelowHorizon(pair.wi) && !isBelowHorizon(pair.wo); }

  Rgb valueAt(const HalfDifferenceBlock& block, std::size_t i, std::vector<Lanes>& scratch) const {
    const GridCorners at(grid_, grid_.position(block.thetaH[i], block.thetaD[i], block.phiD[i]));
    CornerValues values = CornerValues::Zero(), cosines = CornerValues::Ones();
    for (const DictionarySum& sum : sums_) sum.addTo(values, at, scratch);
    values = values.min(highest_.replicate<1, 8>());
    if (transform_ == DataTransform::cosineLog)
      for (int corner = 0; corner < 8; ++corner)
        cosines.col(corner).setConstant(geometry_->weights[Eigen::Index(at.cell(corner))]);
    invertTransform(values.reshaped(), transform_, cosines.reshaped());
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
  Eigen::Array<float, 4, 1> highest_ = Eigen::Array<float, 4, 1>::Zero();
  std::vector<DictionarySum> sums_;
};

}  // namespace

std::unique_ptr<const Brdf> makeCodeBrdf(const Ensemble& ensemble, const SparseCode& code) {
  return std::make_unique<CodeBrdf>(ensemble, code);
}

}  // namespace gonio::dictionary
