// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <functional>
#include <memory>

#include "core/brdf/brdf.h"
#include "core/models/registry.h"
#include "tests/support/random_directions.h"

namespace gonio::test {

/// A BRDF of any function: oracles with wanted faults (not reciprocal, negative, anisotropic) and closed forms.
class FunctionBrdf final : public Brdf {
 public:
  using Function = std::function<Rgb(const Direction& wi, const Direction& wo)>;
  explicit FunctionBrdf(Function function, bool isotropic = true, bool reciprocal = true)
      : function_(std::move(function)), isotropic_(isotropic), reciprocal_(reciprocal) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = function_(pairs[i].wi, pairs[i].wo);
  }
  bool isIsotropic() const override { return isotropic_; }
  bool isReciprocal() const override { return reciprocal_; }

 private:
  Function function_;
  bool isotropic_, reciprocal_;
};

/// The mean over both orders of the directions: what a table that folds phi_d holds of a BRDF that is not reciprocal.
inline FunctionBrdf meanOfBothOrders(std::shared_ptr<const Brdf> brdf) {
  const bool isotropic = brdf->isIsotropic();
  return FunctionBrdf(
      [brdf = std::move(brdf)](const Direction& wi, const Direction& wo) {
        return 0.5 * (brdf->evaluate(wi, wo) + brdf->evaluate(wo, wi));
      },
      isotropic);
}

/// GGX with the given values for the ids of its parameters, the rest at their defaults.
inline std::unique_ptr<const Brdf> ggx(const Rgb& diffuse, const Rgb& specular, double roughness, double f0) {
  const models::ModelSpec& spec = models::ggx().spec();
  models::ParameterValues parameters = models::defaultParameters(spec);
  parameters.values[*spec.find("diffuse")] = diffuse;
  parameters.values[*spec.find("specular")] = specular;
  parameters.values[*spec.find("roughness")] = Rgb(roughness);
  parameters.values[*spec.find("f0")] = Rgb(f0);
  return models::ggx().instantiate(parameters);
}

inline FunctionBrdf lambert(const Rgb& albedo) {
  return FunctionBrdf([albedo](const Direction&, const Direction&) { return albedo / pi; });
}

}  // namespace gonio::test
