// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/interpolation/interpolation.h"

#include "core/brdf/weighted_sum.h"
#include "core/interpolation/interpolation_spaces.h"
#include "core/support/error.h"

namespace gonio::interpolation {

Interpolation::Interpolation(std::span<const InterpolationMaterial> ends)
    : ends_(ends.begin(), ends.end()), tables_(tablesOf(ends)) {
  if (tables_.empty()) throw Error("interpolation: found no material, expected at least one");
}

std::shared_ptr<const Brdf> Interpolation::brdf(std::span<const double> weights) const {
  checkWeights(weights, materials());
  if (const auto end = indexOfFullWeight(weights)) return ends_[*end].material();
  return blendedBrdf(weights);
}

Interpolation::Table Interpolation::table(std::span<const double> weights, const TaskControl& control) const {
  checkWeights(weights, materials());
  if (const auto end = indexOfFullWeight(weights)) return tables_[*end];
  return blendedTable(weights, control);
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
