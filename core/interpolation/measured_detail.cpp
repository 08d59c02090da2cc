// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/interpolation/measured_detail.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/brdf/weighted_sum.h"
#include "core/coordinates/grid_directions.h"
#include "core/dictionary/signals.h"
#include "core/math/parallel.h"

namespace gonio::interpolation {

namespace {

using BrdfPointer = std::shared_ptr<const Brdf>;

/// Pairs that are worked on at once, so that scratch stays on the stack.
constexpr std::size_t chunkPairs = 64;
using Chunk = std::array<Rgb, chunkPairs>;

/// Calls `work(begin, count)` for the chunks of a number of pairs.
template <class Work>
void forChunks(std::size_t pairs, const Work& work) {
  for (std::size_t begin = 0; begin < pairs; begin += chunkPairs) work(begin, std::min(chunkPairs, pairs - begin));
}

/// A material or representation, and its weight > 0.
struct WeightedBrdf {
  BrdfPointer brdf;
  double weight;
};

std::vector<WeightedBrdf> weighted(std::vector<BrdfPointer> brdfs, std::span<const double> weights) {
  std::vector<WeightedBrdf> result;
  for (std::size_t i = 0; i < brdfs.size(); ++i)
    if (weights[i] > 0) result.push_back({std::move(brdfs[i]), weights[i]});
  return result;
}

bool areReciprocal(const std::vector<WeightedBrdf>& parts) {
  return std::ranges::all_of(parts, [](const WeightedBrdf& part) { return part.brdf->isReciprocal(); });
}
bool areIsotropic(const std::vector<WeightedBrdf>& parts) {
  return std::ranges::all_of(parts, [](const WeightedBrdf& part) { return part.brdf->isIsotropic(); });
}

class RepresentationChange final : public Brdf {
 public:
  RepresentationChange(BrdfPointer blend, std::vector<WeightedBrdf> parts)
      : blend_(std::move(blend)), parts_(std::move(parts)) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    blend_->evaluate(pairs, values);
    Chunk results;
    forChunks(pairs.size(), [&](std::size_t begin, std::size_t count) {
      for (const WeightedBrdf& part : parts_) {
        part.brdf->evaluate(pairs.subspan(begin, count), std::span(results).first(count));
        for (std::size_t i = 0; i < count; ++i) values[begin + i] -= part.weight * results[i];
      }
    });
  }

  bool isIsotropic() const override { return blend_->isIsotropic() && areIsotropic(parts_); }
  bool isReciprocal() const override { return blend_->isReciprocal() && areReciprocal(parts_); }
  bool hasImportanceSampling() const override { return blend_->hasImportanceSampling(); }
  double samplingCost() const override { return blend_->samplingCost(); }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return blend_->sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return blend_->pdf(wi, wo); }

 private:
  BrdfPointer blend_;
  std::vector<WeightedBrdf> parts_;
};

class MixtureChange final : public Brdf {
 public:
  MixtureChange(std::shared_ptr<const TransformedMixture> mixture, std::span<const double> weights)
      : mixture_(std::move(mixture)), grid_(mixture_->tables[0].grid), geometry_(dictionary::GridGeometry::of(grid_)) {
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (weights[i] > 0) parts_.push_back({&mixture_->tables[i], float(weights[i])});
  }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    Nodes nodes(3, Eigen::Index(8 * (parts_.size() + 1))), cosines = Nodes::Ones(3, nodes.cols());
    HalfDifferenceBlock block;
    for (std::size_t begin = 0; begin < pairs.size(); begin += HalfDifferenceBlock::capacity) {
      const std::size_t count = std::min(HalfDifferenceBlock::capacity, pairs.size() - begin);
      toHalfDifference(pairs.subspan(begin, count), block);
      for (std::size_t i = 0; i < count; ++i) {
        const auto& [wi, wo] = pairs[begin + i];
        const bool known = block.valid[i] != 0 && !isBelowHorizon(wi) && !isBelowHorizon(wo);
        values[begin + i] = known ? changeAt(block, i, nodes, cosines) : Rgb(0);
      }
    }
  }
  bool isReciprocal() const override { return grid_.reciprocal; }

 private:
  /// Values of the channels at the eight corners: of the blend, then of each material.
  using Nodes = Eigen::Array<float, 3, Eigen::Dynamic>;
  struct Part {
    const TransformedTable* table;
    float weight;
  };

  Rgb changeAt(const HalfDifferenceBlock& block, std::size_t i, Nodes& nodes, Nodes& cosines) const {
    const GridCorners corners(grid_, grid_.position(block.thetaH[i], block.thetaD[i], block.phiD[i]));
    const auto materials = Eigen::Index(parts_.size());
    for (int corner = 0; corner < 8; ++corner) {
      const std::size_t cell = corners.cell(corner);
      auto sum = nodes.col(corner);
      sum.setZero();
      for (Eigen::Index part = 0; part < materials; ++part) {
        const glm::vec3& value = parts_[std::size_t(part)].table->values[cell];
        auto own = nodes.col(8 * (part + 1) + corner);
        own << value.x, value.y, value.z;
        sum += parts_[std::size_t(part)].weight * own;
      }
      if (mixture_->transform == DataTransform::cosineLog)
        for (Eigen::Index set = 0; set <= materials; ++set)
          cosines.col(8 * set + corner).setConstant(geometry_->weights[Eigen::Index(cell)]);
    }
    dictionary::invertTransform(nodes.reshaped(), mixture_->transform, cosines.reshaped());
    return interpolated(corners, nodes);
  }

  /// Corners below the horizon are dropped, as in a table.
  Rgb interpolated(const GridCorners& corners, const Nodes& nodes) const {
    Rgb sum(0);
    double weightSum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      if (geometry_->aboveHorizon[corners.cell(corner)] == 0) continue;
      const double weight = corners.weight(corner);
      weightSum += weight;
      for (int c = 0; c < 3; ++c) {
        double change = double(nodes(c, corner));
        for (std::size_t part = 0; part < parts_.size(); ++part)
          change -= double(parts_[part].weight) * double(nodes(c, Eigen::Index(8 * (part + 1)) + corner));
        sum[c] += weight * change;
      }
    }
    return weightSum > 0 ? sum / weightSum : Rgb(0);
  }

  std::shared_ptr<const TransformedMixture> mixture_;
  HalfDifferenceGrid grid_;
  std::shared_ptr<const dictionary::GridGeometry> geometry_;
  std::vector<Part> parts_;
};

}  // namespace

std::shared_ptr<const Brdf> changeOfSpace(BrdfPointer blend, std::vector<BrdfPointer> representations,
                                          std::span<const double> weights) {
  return std::make_shared<const RepresentationChange>(std::move(blend), weighted(std::move(representations), weights));
}

std::shared_ptr<const Brdf> changeOfSpace(std::shared_ptr<const TransformedMixture> mixture,
                                          std::span<const double> weights) {
  return std::make_shared<const MixtureChange>(std::move(mixture), weights);
}

namespace {

/// The densities of the materials, and for half of the samples that of the change if it has one.
BrdfPointer samplerOf(const std::vector<WeightedBrdf>& materials, const BrdfPointer& change) {
  const double fraction = change->hasImportanceSampling() ? 0.5 : 1;
  std::vector<BrdfPointer> terms;
  std::vector<double> weights;
  for (const auto& [brdf, weight] : materials) {
    terms.push_back(brdf);
    weights.push_back(fraction * weight);
  }
  if (fraction < 1) {
    terms.push_back(change);
    weights.push_back(1 - fraction);
  }
  return weightedSum(std::move(terms), std::move(weights));
}

class DetailBlend final : public Brdf {
 public:
  DetailBlend(std::vector<WeightedBrdf> materials, BrdfPointer change)
      : materials_(std::move(materials)),
        change_(std::move(change)),
        sampler_(samplerOf(materials_, change_)),
        bothOrders_(areReciprocal(materials_) && !change_->isReciprocal()) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    std::vector<Chunk> own(materials_.size());
    forChunks(pairs.size(), [&](std::size_t begin, std::size_t count) {
      evaluateChunk(pairs.subspan(begin, count), values.subspan(begin, count), own);
    });
  }

  bool isIsotropic() const override { return areIsotropic(materials_) && change_->isIsotropic(); }
  bool isReciprocal() const override { return areReciprocal(materials_); }
  bool hasImportanceSampling() const override { return sampler_->hasImportanceSampling(); }
  double samplingCost() const override { return sampler_->samplingCost(); }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return sampler_->sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return sampler_->pdf(wi, wo); }

 private:
  void addChange(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
    Chunk change, exchanged;
    change_->evaluate(pairs, std::span(change).first(pairs.size()));
    if (!bothOrders_) {
      for (std::size_t i = 0; i < pairs.size(); ++i) values[i] += change[i];
      return;
    }
    std::array<DirectionPair, chunkPairs> others;
    for (std::size_t i = 0; i < pairs.size(); ++i) others[i] = {pairs[i].wo, pairs[i].wi};
    change_->evaluate(std::span(others).first(pairs.size()), std::span(exchanged).first(pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i) values[i] += 0.5 * (change[i] + exchanged[i]);
  }

  /// @param own scratch, one chunk per material.
  void evaluateChunk(std::span<const DirectionPair> pairs, std::span<Rgb> values, std::vector<Chunk>& own) const {
    std::ranges::fill(values, Rgb(0));
    for (std::size_t m = 0; m < materials_.size(); ++m) {
      materials_[m].brdf->evaluate(pairs, std::span(own[m]).first(pairs.size()));
      for (std::size_t i = 0; i < pairs.size(); ++i) values[i] += materials_[m].weight * own[m][i];
    }
    Chunk floors;
    floors.fill(Rgb(std::numeric_limits<double>::infinity()));
    for (std::size_t m = 0; m < materials_.size(); ++m)
      for (std::size_t i = 0; i < pairs.size(); ++i)
        floors[i] = glm::min(floors[i], detailFloor(own[m][i], values[i], materials_[m].weight));
    addChange(pairs, values);
    for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = glm::max(floors[i], values[i]);
  }

  std::vector<WeightedBrdf> materials_;
  BrdfPointer change_, sampler_;
  bool bothOrders_;
};

}  // namespace

std::shared_ptr<const Brdf> withMeasuredDetail(std::vector<BrdfPointer> materials, std::span<const double> weights,
                                               BrdfPointer change) {
  return std::make_shared<const DetailBlend>(weighted(std::move(materials), weights), std::move(change));
}

namespace {

/// A table as it is at its nodes, for cells in the order of the grid.
struct CellBlend {
  std::span<const Interpolation::Table> tables;
  std::span<const double> weights;

  /// @return whether the cell is valid in all tables of weight > 0.
  bool isValid(std::size_t cell) const {
    for (std::size_t i = 0; i < tables.size(); ++i)
      if (weights[i] > 0 && tables[i]->valid()[cell] == 0) return false;
    return true;
  }

  TabulatedBrdf::Value at(std::size_t cell, const Rgb& change) const {
    constexpr double largest = std::numeric_limits<float>::max();
    Rgb sum(0), floor(std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < tables.size(); ++i) sum += weights[i] * Rgb(tables[i]->values()[cell]);
    for (std::size_t i = 0; i < tables.size(); ++i)
      if (weights[i] > 0) floor = glm::min(floor, detailFloor(Rgb(tables[i]->values()[cell]), sum, weights[i]));
    return TabulatedBrdf::Value(glm::min(Rgb(largest), glm::max(floor, sum + change)));
  }
};

/// The mean of a change over rotations of both directions about the normal and, with `bothOrders`, over their exchange:
/// what bakeTable() stores of a BRDF.
std::vector<Rgb> meanChange(const Brdf& change, const std::vector<DirectionPair>& pairs, int rotations,
                            bool bothOrders) {
  std::vector<Rgb> sums(pairs.size(), Rgb(0)), results(pairs.size());
  const auto add = [&](const std::vector<DirectionPair>& turned) {
    change.evaluate(turned, results);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += results[i];
  };
  for (int rotation = 0; rotation < rotations; ++rotation) {
    std::vector<DirectionPair> turned = pairs;
    const AzimuthRotation turn(2 * pi * rotation / rotations);
    if (rotation > 0)
      for (DirectionPair& pair : turned) pair = turn(pair);
    add(turned);
    if (!bothOrders) continue;
    for (DirectionPair& pair : turned) std::swap(pair.wi, pair.wo);
    add(turned);
  }
  for (Rgb& sum : sums) sum /= double(rotations * (bothOrders ? 2 : 1));
  return sums;
}

}  // namespace

Interpolation::Table withMeasuredDetail(std::span<const Interpolation::Table> tables, std::span<const double> weights,
                                        const Brdf& change, const TaskControl& control) {
  constexpr std::size_t blockCells = 4096;
  constexpr int azimuths = 16;  // as bakeTable()
  const HalfDifferenceGrid& grid = tables[0]->grid();
  const int rotations = change.isIsotropic() ? 1 : azimuths;
  const bool bothOrders = grid.reciprocal && !change.isReciprocal();
  const GridDirections directions(grid);
  const CellBlend blend{tables, weights};
  std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(0));
  std::vector<std::uint8_t> valid(grid.size(), 0);
  parallelForBlocks(
      grid.size(), blockCells,
      [&](std::size_t begin, std::size_t end) {
        std::vector<std::size_t> cells;
        std::vector<DirectionPair> pairs;
        for (std::size_t cell = begin; cell < end; ++cell) {
          const GridDirections::Node node = directions.at(cell);
          if (!node.aboveHorizon || !blend.isValid(cell)) continue;
          cells.push_back(cell);
          pairs.push_back(node.pair);
        }
        const std::vector<Rgb> changes = meanChange(change, pairs, rotations, bothOrders);
        for (std::size_t i = 0; i < cells.size(); ++i) {
          values[cells[i]] = blend.at(cells[i], changes[i]);
          valid[cells[i]] = 1;
        }
      },
      control);
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid));
}

}  // namespace gonio::interpolation
