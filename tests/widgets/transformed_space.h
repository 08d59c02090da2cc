// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/brdf/data_transform.h"
#include "core/dictionary/signals.h"
#include "core/interpolation/interpolation.h"

namespace gonio::test {

/// Means of transformed tables, transformed back: what the shader is to show, on the CPU.
class TransformedMean final : public Brdf {
 public:
  TransformedMean(DataTransform transform, std::vector<std::shared_ptr<const TabulatedBrdf>> tables,
                  std::vector<double> weights)
      : transform_(transform), tables_(std::move(tables)), weights_(std::move(weights)) {}
  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      Rgb sum(0);
      for (std::size_t m = 0; m < tables_.size(); ++m)
        sum += weights_[m] * tables_[m]->evaluate(pairs[i].wi, pairs[i].wo);
      for (int c = 0; c < 3; ++c)
        values[i][c] = inverseTransformed(transform_, sum[c], cosineWeight(pairs[i].wi.z, pairs[i].wo.z));
    }
  }

 private:
  DataTransform transform_;
  std::vector<std::shared_ptr<const TabulatedBrdf>> tables_;
  std::vector<double> weights_;
};

inline std::vector<interpolation::InterpolationMaterial> endsOf(
    const std::vector<interpolation::Interpolation::Table>& tables) {
  std::vector<interpolation::InterpolationMaterial> ends;
  for (const auto& table : tables) ends.push_back({.table = table});
  return ends;
}

/// A space whose mixture lies in a transformed domain, as that of sparse codes does.
class TransformedSpace final : public interpolation::Interpolation {
 public:
  TransformedSpace(const std::vector<Table>& tables, DataTransform transform)
      : interpolation::Interpolation(endsOf(tables)), transform_(transform) {
    mixture_.transform = transform;
    for (const Table& table : this->tables()) {
      std::vector<glm::vec3> values(table->values().begin(), table->values().end());
      const auto geometry = dictionary::GridGeometry::of(table->grid());
      for (std::size_t cell = 0; cell < values.size(); ++cell)
        for (int c = 0; c < 3; ++c)
          values[cell][c] = float(transformed(transform, values[cell][c], geometry->weights[Eigen::Index(cell)]));
      const std::vector<std::uint8_t> valid(table->valid().begin(), table->valid().end());
      mixture_.tables.push_back({table->grid(), values, valid});
      transformed_.push_back(std::make_shared<const TabulatedBrdf>(table->grid(), values, valid));
    }
  }
  std::shared_ptr<const interpolation::TransformedMixture> mixture() const override {
    return std::make_shared<const interpolation::TransformedMixture>(mixture_);
  }

 private:
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    return std::make_shared<TransformedMean>(transform_, transformed_,
                                             std::vector<double>(weights.begin(), weights.end()));
  }
  DataTransform transform_;
  interpolation::TransformedMixture mixture_;
  std::vector<std::shared_ptr<const TabulatedBrdf>> transformed_;
};

}  // namespace gonio::test
