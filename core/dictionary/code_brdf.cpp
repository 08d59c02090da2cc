// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_brdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/coordinates/half_difference_block.h"
#include "core/dictionary/decode.h"

namespace gonio::dictionary {

namespace {

/// Between two nodes of an axis: the first, the second, and how far.
struct Place {
  int low = 0, high = 0;
  float fraction = 0;
};

/// At an open end values stay.
Place clamped(double position, int count) {
  const double x = std::clamp(position, 0.0, double(count - 1));
  const int low = std::min(int(x), count - 1);
  return {low, std::min(low + 1, count - 1), float(x - low)};
}

/// @param position in [0, count].
Place wrapped(double position, int count) {
  const int low = std::min(int(position), count - 1);
  return {low, low + 1 == count ? 0 : low + 1, float(position - low)};
}

/// The atoms of one mode that a channel uses, those of a node side by side.
class Atoms {
 public:
  Atoms(const Eigen::MatrixXd& mode, const std::vector<int>& used) : count_(used.size()) {
    values_.resize(std::size_t(mode.rows()) * count_);
    for (Eigen::Index node = 0; node < mode.rows(); ++node)
      for (std::size_t a = 0; a < count_; ++a) values_[std::size_t(node) * count_ + a] = float(mode(node, used[a]));
  }

  void at(const Place& place, float* result) const {
    const float* low = values_.data() + std::size_t(place.low) * count_;
    const float* high = values_.data() + std::size_t(place.high) * count_;
    for (std::size_t a = 0; a < count_; ++a) result[a] = low[a] + place.fraction * (high[a] - low[a]);
  }
  std::size_t count() const { return count_; }

 private:
  std::size_t count_;
  std::vector<float> values_;
};

/// One channel: its coefficients grouped by the atoms of modes 1 and 2, so that a coefficient costs one product.
class ChannelSum {
 public:
  ChannelSum(const std::array<Eigen::MatrixXd, 3>& atoms, const ChannelCode& channel) : highest_(channel.highest) {
    const std::uint32_t n0 = std::uint32_t(atoms[0].rows()), n1 = std::uint32_t(atoms[1].rows());
    std::vector<Coefficient<float>> sorted = channel.coefficients;
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
    std::array<std::map<int, std::uint16_t>, 3> places;
    std::array<std::vector<int>, 3> used;
    const auto place = [&](std::size_t mode, std::uint32_t atom) {
      const auto [found, isNew] = places[mode].try_emplace(int(atom), std::uint16_t(used[mode].size()));
      if (isNew) used[mode].push_back(int(atom));
      return found->second;
    };
    for (const Coefficient<float>& c : sorted) {
      const std::uint16_t atom1 = place(1, c.index / n0 % n1), atom2 = place(2, c.index / (n0 * n1));
      if (groups_.empty() || groups_.back().atom1 != atom1 || groups_.back().atom2 != atom2)
        groups_.push_back({atom1, atom2, std::uint32_t(values_.size()), 0});
      atoms0_.push_back(place(0, c.index % n0));
      values_.push_back(c.value);
      groups_.back().end = std::uint32_t(values_.size());
    }
    for (std::size_t mode = 0; mode < 3; ++mode) atoms_.emplace_back(atoms[mode], used[mode]);
  }

  float at(const std::array<Place, 3>& places, std::vector<float>& scratch) const {
    scratch.resize(atoms_[0].count() + atoms_[1].count() + atoms_[2].count());
    float* const a0 = scratch.data();
    float* const a1 = a0 + atoms_[0].count();
    float* const a2 = a1 + atoms_[1].count();
    atoms_[0].at(places[0], a0);
    atoms_[1].at(places[1], a1);
    atoms_[2].at(places[2], a2);
    float sum = 0;
    for (const Group& group : groups_) {
      float inner = 0;
      for (std::uint32_t i = group.begin; i < group.end; ++i) inner += values_[i] * a0[atoms0_[i]];
      sum += inner * a1[group.atom1] * a2[group.atom2];
    }
    return std::min(sum, highest_);
  }

 private:
  struct Group {
    std::uint16_t atom1, atom2;
    std::uint32_t begin, end;
  };
  std::vector<Atoms> atoms_;
  std::vector<Group> groups_;
  std::vector<std::uint16_t> atoms0_;
  std::vector<float> values_;
  float highest_;
};

class CodeBrdf final : public Brdf {
 public:
  CodeBrdf(const Ensemble& ensemble, const SparseCode& code) : grid_(code.grid), transform_(code.transform) {
    checkCode(ensemble, code);
    const auto geometry = GridGeometry::of(code.grid);
    for (const ChannelCode& channel : code.channels)
      channels_.emplace_back(
          unscaledAtoms(ensemble.dictionaries[std::size_t(channel.dictionary)], *geometry, code.scaled), channel);
  }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    std::vector<float> scratch;
    HalfDifferenceBlock block;
    for (std::size_t begin = 0; begin < pairs.size(); begin += HalfDifferenceBlock::capacity) {
      const std::size_t length = std::min(HalfDifferenceBlock::capacity, pairs.size() - begin);
      toHalfDifference(pairs.subspan(begin, length), block);
      for (std::size_t i = 0; i < length; ++i)
        values[begin + i] = block.valid[i] != 0 && isAboveHorizon(pairs[begin + i])
                                ? valueAt(block, i, pairs[begin + i], scratch)
                                : Rgb(0);
    }
  }
  bool isReciprocal() const override { return grid_.reciprocal; }

 private:
  static bool isAboveHorizon(const DirectionPair& pair) { return !isBelowHorizon(pair.wi) && !isBelowHorizon(pair.wo); }

  Rgb valueAt(const HalfDifferenceBlock& block, std::size_t i, const DirectionPair& pair,
              std::vector<float>& scratch) const {
    const auto position = grid_.position(block.thetaH[i], block.thetaD[i], block.phiD[i]);
    const std::array<Place, 3> places{wrapped(position.phiD, grid_.phiDCount),
                                      clamped(position.thetaD, grid_.thetaDCount),
                                      clamped(position.thetaH, grid_.thetaHCount)};
    const double weight = cosineWeight(pair.wi.z, pair.wo.z);
    Rgb value;
    for (int c = 0; c < 3; ++c)
      value[c] = inverseTransformed(transform_, double(channels_[std::size_t(c)].at(places, scratch)), weight);
    return value;
  }

  HalfDifferenceGrid grid_;
  DataTransform transform_;
  std::vector<ChannelSum> channels_;
};

}  // namespace

std::unique_ptr<const Brdf> makeCodeBrdf(const Ensemble& ensemble, const SparseCode& code) {
  return std::make_unique<CodeBrdf>(ensemble, code);
}

}  // namespace gonio::dictionary
