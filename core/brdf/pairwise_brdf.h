// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <utility>

#include "core/brdf/brdf.h"

namespace gonio {

/// An isotropic BRDF that calls a function per pair, only for pairs with both directions at or above the horizon.
/// @tparam Value callable as Rgb(const Direction& wi, const Direction& wo), const, from several threads at once;
/// returns finite linear RGB, 1/sr, without the cosine.
template <typename Value>
class PairwiseBrdf final : public Brdf {
 public:
  PairwiseBrdf(Value value, bool reciprocal) : value_(std::move(value)), reciprocal_(reciprocal) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [wi, wo] = pairs[i];
      values[i] = isBelowHorizon(wi) || isBelowHorizon(wo) ? Rgb(0) : value_(wi, wo);
    }
  }
  bool isReciprocal() const override { return reciprocal_; }

 private:
  Value value_;
  bool reciprocal_;
};

template <typename Value>
std::shared_ptr<const Brdf> makePairwiseBrdf(Value value, bool reciprocal = true) {
  return std::make_shared<const PairwiseBrdf<Value>>(std::move(value), reciprocal);
}

}  // namespace gonio
