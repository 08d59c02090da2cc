// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit_parameters.h"

#include <algorithm>

#include "core/models/common_parameters.h"

namespace gonio::fitting {

FitRole fitRole(const models::ModelSpec& spec, const models::ParameterValues& base, std::size_t parameter,
                DataSymmetry symmetry) {
  const models::ParameterSpec& p = spec.parameters[parameter];
  if (!p.choices.empty()) return FitRole::fixed;
  if (!p.activeWith.empty()) {
    const auto choice = spec.find(p.activeWith);
    if (choice && models::chosen(base.values[*choice].x) != p.activeChoice) return FitRole::fixed;
  }
  if (symmetry == DataSymmetry::isotropic) {
    if (p.anisotropicOnly) return FitRole::fixed;
    if (!p.isotropicTwin.empty() && spec.find(p.isotropicTwin)) return FitRole::twin;
  }
  return p.linear && p.perChannel && p.hardMin <= 0 ? FitRole::linear : FitRole::nonlinear;
}

std::vector<std::size_t> parametersOf(const models::ModelSpec& spec, const models::ParameterValues& base, FitRole role,
                                      DataSymmetry symmetry) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i)
    if (fitRole(spec, base, i, symmetry) == role) result.push_back(i);
  return result;
}

std::vector<std::size_t> optionalLobes(const models::ModelSpec& spec) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const models::ParameterSpec& choice = spec.parameters[i];
    const bool switchesLobe = std::ranges::any_of(spec.parameters, [&](const models::ParameterSpec& p) {
      return p.role == models::ParameterRole::width && p.activeWith == choice.id &&
             p.activeChoice == models::chosen(choice.defaultValue);
    });
    if (!choice.choices.empty() && switchesLobe) result.push_back(i);
  }
  return result;
}

void copyToTwins(const models::ModelSpec& spec, models::ParameterValues& values, DataSymmetry symmetry) {
  for (std::size_t i = 0; i < spec.parameters.size(); ++i)
    if (fitRole(spec, values, i, symmetry) == FitRole::twin)
      values.values[i] = values.values[*spec.find(spec.parameters[i].isotropicTwin)];
}

std::size_t fittedParameterCount(const models::ModelSpec& spec, DataSymmetry symmetry) {
  std::size_t count = 0;
  for (const FitRole role : {FitRole::linear, FitRole::nonlinear})
    for (const std::size_t i : parametersOf(spec, models::defaultParameters(spec), role, symmetry))
      count += spec.parameters[i].perChannel ? 3 : 1;
  return count;
}

}  // namespace gonio::fitting
