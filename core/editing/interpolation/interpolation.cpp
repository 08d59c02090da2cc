// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/interpolation/interpolation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/editing/interpolation/interpolation_spaces.h"
#include "core/support/error.h"

namespace gonio::editing {

namespace {

/// The material that has all of the weight.
std::optional<std::size_t> wholeEnd(std::span<const double> weights) {
  const auto whole = std::find(weights.begin(), weights.end(), 1.0);
  if (whole == weights.end()) return {};
  return std::size_t(whole - weights.begin());
}

}  // namespace

void checkWeights(std::span<const double> weights, std::size_t materials) {
  constexpr double slack = 1e-9;
  if (weights.size() != materials)
    throw Error("found " + std::to_string(weights.size()) + " weights, expected " + std::to_string(materials) +
                ": one a material");
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] >= 0 && weights[i] <= 1))
      throw Error("the weight of material " + std::to_string(i + 1) + " is " + std::to_string(weights[i]) +
                  "; expected a number from 0 to 1");
    sum += weights[i];
  }
  if (std::abs(sum - 1) > slack) throw Error("the weights add up to " + std::to_string(sum) + "; expected 1");
}

Interpolation::Interpolation(std::vector<Table> tables) : tables_(std::move(tables)) {
  if (tables_.empty()) throw Error("there is no material to interpolate between");
}

std::shared_ptr<const Brdf> Interpolation::brdf(std::span<const double> weights) const {
  checkWeights(weights, materials());
  if (const auto end = wholeEnd(weights)) return tables_[*end];
  return blendedBrdf(weights);
}

Interpolation::Table Interpolation::table(std::span<const double> weights, const TaskControl& control) const {
  checkWeights(weights, materials());
  if (const auto end = wholeEnd(weights)) return tables_[*end];
  return blendedTable(weights, control);
}

std::optional<models::ParameterValues> Interpolation::parameters(std::span<const double> weights) const {
  checkWeights(weights, materials());
  return blendedParameters(weights);
}

std::vector<DifferentialEdit> Interpolation::moves(std::span<const double> weights) const {
  checkWeights(weights, materials());
  return movesTo(weights);
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
                                                          std::span<const InterpolationEnd> ends,
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
      return prepareLinear(ends);
  }
}

}  // namespace gonio::editing
