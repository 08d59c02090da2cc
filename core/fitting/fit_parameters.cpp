// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit_parameters.h"

#include "core/models/common_parameters.h"

namespace gonio::fitting {

FitRole fitRole(const models::ModelSpec& spec, std::size_t parameter) {
  const models::ParameterSpec& p = spec.parameters[parameter];
  if (!p.choices.empty()) return FitRole::fixed;
  if (!p.activeWith.empty()) {
    // A fit leaves choices at their defaults.
    const auto choice = spec.find(p.activeWith);
    if (choice && models::chosen(spec.parameters[*choice].defaultValue) != p.activeChoice) return FitRole::fixed;
  }
  if (!p.isotropicTwin.empty() && spec.find(p.isotropicTwin)) return FitRole::twin;
  return p.linear && p.perChannel && p.hardMin <= 0 ? FitRole::linear : FitRole::nonlinear;
}

std::vector<std::size_t> parametersOf(const models::ModelSpec& spec, FitRole role) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i)
    if (fitRole(spec, i) == role) result.push_back(i);
  return result;
}

void copyToTwins(const models::ModelSpec& spec, models::ParameterValues& values) {
  for (std::size_t i = 0; i < spec.parameters.size(); ++i)
    if (fitRole(spec, i) == FitRole::twin)
      values.values[i] = values.values[*spec.find(spec.parameters[i].isotropicTwin)];
}

std::size_t fittedParameterCount(const models::ModelSpec& spec) {
  std::size_t count = 0;
  for (const FitRole role : {FitRole::linear, FitRole::nonlinear})
    for (const std::size_t i : parametersOf(spec, role)) count += spec.parameters[i].perChannel ? 3 : 1;
  return count;
}

}  // namespace gonio::fitting
