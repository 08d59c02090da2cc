// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/models/model.h"

namespace gonio::models {

/// A BRDF of Model::instantiate() that also provides its model and parameters, for materials that are models, such as
/// published fits.
class ModelBrdf final : public Brdf {
 public:
  /// @throws Error as Model::instantiate().
  ModelBrdf(const Model& model, ParameterValues parameters);

  const Model& model() const { return model_; }
  const ParameterValues& parameters() const { return parameters_; }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    brdf_->evaluate(pairs, values);
  }
  bool isIsotropic() const override { return brdf_->isIsotropic(); }
  bool isReciprocal() const override { return brdf_->isReciprocal(); }
  bool isMirrorSymmetric() const override { return brdf_->isMirrorSymmetric(); }
  bool hasData(const DirectionPair& pair) const override { return brdf_->hasData(pair); }
  bool hasImportanceSampling() const override { return brdf_->hasImportanceSampling(); }
  double samplingCost() const override { return brdf_->samplingCost(); }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return brdf_->sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return brdf_->pdf(wi, wo); }

 private:
  const Model& model_;
  ParameterValues parameters_;
  std::unique_ptr<const Brdf> brdf_;
};

}  // namespace gonio::models
