// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/weighted_sum.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "core/brdf/value_bound.h"
#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio {

void checkWeights(std::span<const double> weights, std::size_t materials) {
  constexpr double slack = 1e-9;
  if (weights.size() != materials)
    throw Error("found " + std::to_string(weights.size()) + " weights, expected " + std::to_string(materials) +
                ": one per material");
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] >= 0 && weights[i] <= 1))
      throw Error("the weight of material " + std::to_string(i + 1) + " is " + std::to_string(weights[i]) +
                  "; expected a number from 0 to 1");
    sum += weights[i];
  }
  if (std::abs(sum - 1) > slack) throw Error("the weights add up to " + std::to_string(sum) + "; expected 1");
}

std::optional<std::size_t> indexOfFullWeight(std::span<const double> weights) {
  const auto whole = std::find(weights.begin(), weights.end(), 1.0);
  if (whole == weights.end()) return {};
  return std::size_t(whole - weights.begin());
}

namespace {

constexpr std::size_t blockCells = 4096;

class SumBound final : public ValueBound {
 public:
  SumBound(std::vector<std::shared_ptr<const ValueBound>> terms, std::vector<double> weights)
      : terms_(std::move(terms)), weights_(std::move(weights)) {}

  RgbRange over(const PairBox& box) const override {
    RgbRange sum;
    for (std::size_t term = 0; term < terms_.size(); ++term) {
      const RgbRange one = terms_[term]->over(box);
      sum.low += weights_[term] * one.low;
      sum.high += weights_[term] * one.high;
    }
    return sum;
  }
  bool isLocal() const override {
    return std::ranges::all_of(terms_, [](const auto& term) { return term->isLocal(); });
  }

 private:
  std::vector<std::shared_ptr<const ValueBound>> terms_;
  std::vector<double> weights_;
};

class WeightedSum final : public Brdf {
 public:
  WeightedSum(std::vector<std::shared_ptr<const Brdf>> terms, std::vector<double> weights)
      : terms_(std::move(terms)), weights_(std::move(weights)) {
    for (const double weight : weights_) total_ += weight;
  }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    constexpr std::size_t chunk = 64;
    std::array<Rgb, chunk> results;
    for (std::size_t begin = 0; begin < pairs.size(); begin += chunk) {
      const auto part = pairs.subspan(begin, std::min(chunk, pairs.size() - begin));
      const auto sums = values.subspan(begin, part.size());
      std::fill(sums.begin(), sums.end(), Rgb(0));
      for (std::size_t term = 0; term < terms_.size(); ++term) {
        terms_[term]->evaluate(part, std::span(results).first(part.size()));
        for (std::size_t i = 0; i < part.size(); ++i) sums[i] += weights_[term] * results[i];
      }
    }
  }

  bool isIsotropic() const override {
    return std::all_of(terms_.begin(), terms_.end(), [](const auto& term) { return term->isIsotropic(); });
  }
  bool hasImportanceSampling() const override {
    return std::all_of(terms_.begin(), terms_.end(), [](const auto& term) { return term->hasImportanceSampling(); });
  }
  double samplingCost() const override {
    double cost = 0;
    for (const auto& term : terms_) cost = std::max(cost, term->samplingCost());
    return cost;
  }
  bool isReciprocal() const override {
    return std::all_of(terms_.begin(), terms_.end(), [](const auto& term) { return term->isReciprocal(); });
  }

  std::shared_ptr<const ValueBound> valueBound() const override {
    std::vector<std::shared_ptr<const ValueBound>> bounds;
    for (const auto& term : terms_)
      if (!bounds.emplace_back(term->valueBound())) return nullptr;
    return std::make_shared<const SumBound>(std::move(bounds), weights_);
  }

  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override {
    double left = u.x * total_;
    std::size_t term = 0;
    while (term + 1 < terms_.size() && left >= weights_[term]) left -= weights_[term++];
    // The remainder of the random number samples within the term.
    const double inner = std::clamp(left / weights_[term], 0.0, 1 - std::numeric_limits<double>::epsilon());
    DirectionSample result = terms_[term]->sample(wo, {inner, u.y, u.z});
    if (result.pdf > 0) result.pdf = pdf(result.wi, wo);
    return result;
  }
  double pdf(const Direction& wi, const Direction& wo) const override {
    double sum = 0;
    for (std::size_t term = 0; term < terms_.size(); ++term) sum += weights_[term] * terms_[term]->pdf(wi, wo);
    return sum / total_;
  }

 private:
  std::vector<std::shared_ptr<const Brdf>> terms_;
  std::vector<double> weights_;
  double total_ = 0;
};

}  // namespace

std::shared_ptr<const Brdf> weightedSum(std::vector<std::shared_ptr<const Brdf>> terms, std::vector<double> weights) {
  assert(terms.size() == weights.size());
  for (std::size_t i = terms.size(); i-- > 0;) {
    if (weights[i] > 0) continue;
    terms.erase(terms.begin() + std::ptrdiff_t(i));
    weights.erase(weights.begin() + std::ptrdiff_t(i));
  }
  assert(!terms.empty());
  return std::make_shared<const WeightedSum>(std::move(terms), std::move(weights));
}

std::shared_ptr<const TabulatedBrdf> weightedSum(std::span<const std::shared_ptr<const TabulatedBrdf>> tables,
                                                 std::span<const double> weights, const TaskControl& control) {
  assert(!tables.empty() && tables.size() == weights.size());
  const HalfDifferenceGrid& grid = tables[0]->grid();
  std::vector<TabulatedBrdf::Value> values(grid.size());
  std::vector<std::uint8_t> valid(grid.size());
  parallelForBlocks(
      grid.size(), blockCells,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
          Rgb sum(0);
          bool known = true;
          for (std::size_t i = 0; i < tables.size(); ++i) {
            if (!(weights[i] > 0)) continue;
            known = known && tables[i]->valid()[cell];
            sum += weights[i] * Rgb(tables[i]->values()[cell]);
          }
          valid[cell] = known;
          values[cell] = known ? TabulatedBrdf::Value(sum) : TabulatedBrdf::Value(0);
        }
      },
      control);
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid));
}

std::shared_ptr<const TabulatedBrdf> onGrid(const std::shared_ptr<const TabulatedBrdf>& table,
                                            const HalfDifferenceGrid& grid, const TaskControl& control) {
  if (table->grid() == grid) return table;
  if (grid.reciprocal && !table->isReciprocal()) return onGrid(meanOfOrders(table), grid, control);
  std::vector<TabulatedBrdf::Value> values(grid.size());
  std::vector<std::uint8_t> valid(grid.size());
  const GridDirections directions(grid);
  parallelForBlocks(
      grid.size(), blockCells,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
          if (!directions.at(cell).aboveHorizon) continue;
          bool known = false;
          const Rgb value = table->lookup(grid.node(cell), TableLookup::trilinear, &known);
          valid[cell] = known;
          values[cell] = TabulatedBrdf::Value(value);
        }
      },
      control);
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid), NegativeValues::stay);
}

}  // namespace gonio
