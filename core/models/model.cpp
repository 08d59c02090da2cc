// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/model.h"

#include <algorithm>
#include <cmath>

#include "core/support/error.h"

namespace gonio::models {

namespace {

ParameterValues clamped(const ModelSpec& spec, ParameterValues parameters) {
  clampToHardRange(spec, parameters);
  return parameters;
}

}  // namespace

std::optional<std::size_t> ModelSpec::find(std::string_view parameterId) const {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].id == parameterId) return i;
  return std::nullopt;
}

Model::Model(const ModelSpec& spec, const Functions& functions) : spec_(spec), functions_(functions) {
  if (functions.shaderParameters)
    shaderComponents_.assign(shaderParameters(defaultParameters(spec)).size(), 3);
  else
    for (const ParameterSpec& parameter : spec.parameters) shaderComponents_.push_back(parameter.perChannel ? 3 : 1);
}

std::unique_ptr<const Brdf> Model::instantiate(const ParameterValues& parameters) const {
  return functions_.create(clamped(spec_, parameters));
}

std::unique_ptr<const Brdf> Model::instantiateUnclamped(const ParameterValues& parameters) const {
  const auto create = functions_.createUnclamped ? functions_.createUnclamped : functions_.create;
  return create(clamped(spec_, parameters));
}

std::vector<glm::vec3> Model::shaderParameters(const ParameterValues& parameters) const {
  const ParameterValues used = clamped(spec_, parameters);
  if (functions_.shaderParameters) return functions_.shaderParameters(used);
  return {used.values.begin(), used.values.end()};
}

std::vector<ModelLobe> Model::lobes(const ParameterValues& parameters) const {
  return functions_.lobes(clamped(spec_, parameters));
}

ParameterValues Model::canonical(const ParameterValues& parameters) const {
  return functions_.canonical ? functions_.canonical(parameters) : parameters;
}

ParameterValues defaultParameters(const ModelSpec& spec) {
  ParameterValues result;
  for (const ParameterSpec& parameter : spec.parameters) result.values.emplace_back(parameter.defaultValue);
  return result;
}

std::vector<ClampedParameter> clampToHardRange(const ModelSpec& spec, ParameterValues& parameters) {
  if (parameters.values.size() != spec.parameters.size())
    throw Error("model " + std::string(spec.id) + ": found " + std::to_string(parameters.values.size()) +
                " parameter values, expected " + std::to_string(spec.parameters.size()));
  std::vector<ClampedParameter> clamped;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const ParameterSpec& parameter = spec.parameters[i];
    for (int channel = 0; channel < 3; ++channel) {
      double& value = parameters.values[i][channel];
      if (!std::isfinite(value))
        throw Error("model " + std::string(spec.id) + ": parameter " + std::string(parameter.id) +
                    " is not a finite number");
      const double used = std::clamp(value, parameter.hardMin, parameter.hardMax);
      if (used != value) clamped.push_back({parameter.id, channel, value, used});
      value = used;
    }
  }
  return clamped;
}

}  // namespace gonio::models
