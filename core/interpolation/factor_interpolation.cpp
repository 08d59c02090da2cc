// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/deviation_grid.h"
#include "core/factorization/pdv_blend.h"
#include "core/interpolation/interpolation_spaces.h"

namespace gonio::editing {

namespace {

using factorization::PdvFactors;
using Factors = std::shared_ptr<const PdvFactors>;

class FactorInterpolation final : public Interpolation {
 public:
  /// @throws Error when the factors cannot be blended.
  FactorInterpolation(std::span<const InterpolationMaterial> materials, std::vector<Factors> factors)
      : Interpolation(materials), factors_(std::move(factors)) {
    factorization::checkBlendable(curves());
  }

 private:
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    return factorization::makePdvBrdf(blended(weights));
  }
  std::optional<PdvFactors> blendedFactors(std::span<const double> weights) const override { return blended(weights); }
  PdvFactors blended(std::span<const double> weights) const { return factorization::blended(curves(), weights); }
  std::vector<const PdvFactors*> curves() const {
    std::vector<const PdvFactors*> curves;
    for (const Factors& factors : factors_) curves.push_back(factors.get());
    return curves;
  }

  std::vector<Factors> factors_;
};

/// The options that all factorisations share: those of the first material that has factors, else nodes for the set.
factorization::PdvOptions sharedOptions(std::span<const InterpolationMaterial> ends,
                                        const InterpolationOptions& options, const TaskControl& control) {
  for (const InterpolationMaterial& end : ends)
    if (end.factors)
      return {.form = end.factors->form,
              .transform = end.factors->transform,
              .terms = end.factors->terms(),
              .deviationNodes = end.factors->deviationNodes};
  factorization::PdvOptions shared = options.pdv;
  if (shared.deviationNodes.empty() && !ends.empty())
    shared.deviationNodes = factorization::deviationNodes(tablesOf(ends), factorization::defaultDeviations, control);
  return shared;
}

}  // namespace

std::shared_ptr<const Interpolation> prepareFactors(std::span<const InterpolationMaterial> ends,
                                                    const InterpolationOptions& options, const TaskControl& control) {
  constexpr double nodesFraction = 0.1;
  const factorization::PdvOptions shared = sharedOptions(ends, options, control.between(0, nodesFraction));
  std::vector<Factors> factors;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double each = (1 - nodesFraction) / double(ends.size()), begin = nodesFraction + double(i) * each;
    factors.push_back(ends[i].factors
                          ? ends[i].factors
                          : std::make_shared<const PdvFactors>(
                                factorizePdv(*ends[i].table, shared, control.between(begin, begin + each)).factors));
  }
  return std::make_shared<const FactorInterpolation>(ends, std::move(factors));
}

}  // namespace gonio::editing
