// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <utility>

#include "core/brdf/brdf.h"

namespace gonio {

/// An isotropic BRDF that calls a function per pair, only for pairs with both directions at or above the horizon.
/// @tparam Reflectance callable as Rgb(const Direction& wi, const Direction& wo), const, from several threads at once;
/// returns finite linear RGB, 1/sr, without the cosine.
template <typename Reflectance>
class PairwiseBrdf final : public Brdf {
 public:
  PairwiseBrdf(Reflectance reflectance, bool reciprocal)
      : reflectance_(std::move(reflectance)), reciprocal_(reciprocal) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [wi, wo] = pairs[i];
      values[i] = isBelowHorizon(wi) || isBelowHorizon(wo) ? Rgb(0) : reflectance_(wi, wo);
    }
  }
  bool isReciprocal() const override { return reciprocal_; }

 private:
  Reflectance reflectance_;
  bool reciprocal_;
};

template <typename Reflectance>
std::shared_ptr<const Brdf> makePairwiseBrdf(Reflectance reflectance, bool reciprocal = true) {
  return std::make_shared<const PairwiseBrdf<Reflectance>>(std::move(reflectance), reciprocal);
}

}  // namespace gonio
