// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/interpolation/interpolation.h"

#include "core/brdf/weighted_sum.h"
#include "core/interpolation/interpolation_spaces.h"
#include "core/interpolation/measured_detail.h"
#include "core/support/error.h"

namespace gonio::interpolation {

Interpolation::Interpolation(std::span<const InterpolationMaterial> ends, bool preservesDetail)
    : ends_(ends.begin(), ends.end()), tables_(tablesOf(ends)), preservesDetail_(preservesDetail) {
  if (tables_.empty()) throw Error("interpolation: found no material, expected at least one");
}

std::shared_ptr<const Brdf> Interpolation::brdf(std::span<const double> weights) const {
  checkWeights(weights, materials());
  if (const auto end = indexOfFullWeight(weights)) return ends_[*end].material();
  if (!preservesDetail_) return blendedBrdf(weights);
  std::vector<std::shared_ptr<const Brdf>> materials;
  for (const InterpolationMaterial& end : ends_) materials.push_back(end.material());
  return withMeasuredDetail(std::move(materials), weights, change(weights));
}

Interpolation::Table Interpolation::table(std::span<const double> weights, const TaskControl& control) const {
  checkWeights(weights, materials());
  if (const auto end = indexOfFullWeight(weights)) return tables_[*end];
  if (!preservesDetail_) return blendedTable(weights, control);
  constexpr double resampledFraction = 0.3;
  return withMeasuredDetail(onOneGrid(tables_, control.between(0, resampledFraction)), weights, *change(weights),
                            control.between(resampledFraction, 1));
}

std::optional<models::ParameterValues> Interpolation::parameters(std::span<const double> weights) const {
  checkWeights(weights, materials());
  return blendedParameters(weights);
}

std::vector<editing::DifferentialEdit> Interpolation::differentialEdits(std::span<const double> weights) const {
  checkWeights(weights, materials());
  return blendedEdits(weights);
}

std::optional<factorization::PdvFactors> Interpolation::factors(std::span<const double> weights) const {
  checkWeights(weights, materials());
  return blendedFactors(weights);
}

std::optional<dictionary::SparseCode> Interpolation::code(std::span<const double> weights) const {
  checkWeights(weights, materials());
  return blendedCode(weights);
}

Interpolation::Table Interpolation::blendedTable(std::span<const double> weights, const TaskControl& control) const {
  return bakeTable(*blendedBrdf(weights), tables_[0]->grid(), control);
}

std::shared_ptr<const Brdf> Interpolation::change(std::span<const double> weights) const {
  std::vector<std::shared_ptr<const Brdf>> representations(materials());
  for (std::size_t i = 0; i < materials(); ++i) {
    if (!(weights[i] > 0)) continue;
    std::vector<double> whole(materials(), 0.0);
    whole[i] = 1;
    representations[i] = blendedBrdf(whole);
  }
  return changeOfSpace(blendedBrdf(weights), std::move(representations), weights);
}

std::shared_ptr<const Interpolation> prepareInterpolation(InterpolationSpace space,
                                                          std::span<const InterpolationMaterial> ends,
                                                          const InterpolationOptions& options,
                                                          const TaskControl& control) {
  switch (space) {
    case InterpolationSpace::parameters:
      return prepareParametric(ends, false, options, control);
    case InterpolationSpace::differential:
      return prepareParametric(ends, true, options, control);
    case InterpolationSpace::factors:
      return prepareFactors(ends, options, control);
    case InterpolationSpace::dictionary:
      return prepareDictionary(ends, options, control);
    default:
      return prepareLinear(ends, control);
  }
}

}  // namespace gonio::interpolation
