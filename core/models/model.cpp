// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "core/brdf/weighted_sum.h"
#include "core/models/shader_arguments.h"
#include "core/support/error.h"

namespace gonio::models {

namespace {

ParameterValues clamped(const ModelSpec& spec, ParameterValues parameters) {
  clampToHardRange(spec, parameters);
  return parameters;
}

double blend(const ParameterSpec& parameter, std::span<const double> values, std::span<const double> weights) {
  // Equal values stay as they are, to the last bit.
  if (std::equal(values.begin() + 1, values.end(), values.begin())) return values[0];
  const bool geometric = parameter.scale == ParameterScale::logarithmic &&
                         std::all_of(values.begin(), values.end(), [](double value) { return value > 0; });
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (weights[i] > 0) sum += weights[i] * (geometric ? std::log(values[i]) : values[i]);
  return geometric ? std::exp(sum) : sum;
}

}  // namespace

std::optional<std::size_t> ModelSpec::find(std::string_view parameterId) const {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].id == parameterId) return i;
  return std::nullopt;
}

std::string ModelSpec::shaderName() const {
  std::string word(id);
  std::ranges::replace(word, '-', '_');
  return word;
}

std::string ModelSpec::formulaFile() const {
  return "core/models/" + (file.empty() ? shaderName() : std::string(file)) + ".glsl";
}

Model::Model(const ModelSpec& spec, const Functions& functions) : spec_(spec), functions_(functions) {
  const ShaderArguments arguments = functions.arguments(defaultParameters(spec));
  shaderArguments_ = arguments.text();
  shaderVectors_ = arguments.packed().size();
}

std::unique_ptr<const Brdf> Model::instantiate(const ParameterValues& parameters) const {
  return functions_.create(clamped(spec_, parameters));
}

std::unique_ptr<const Brdf> Model::instantiateUnclamped(const ParameterValues& parameters) const {
  const auto create = functions_.createUnclamped ? functions_.createUnclamped : functions_.create;
  return create(clamped(spec_, parameters));
}

std::vector<glm::vec4> Model::shaderParameters(const ParameterValues& parameters) const {
  return functions_.arguments(clamped(spec_, parameters)).packed();
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

void checkHardRange(const ModelSpec& spec, const ParameterValues& parameters) {
  const auto text = [](double number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%g", number);
    return std::string(digits);
  };
  ParameterValues checked = parameters;
  std::string sentence;
  std::string_view last;
  for (const ClampedParameter& one : clampToHardRange(spec, checked)) {
    const std::size_t index = spec.find(one.id).value();
    const ParameterSpec& parameter = spec.parameters[index];
    const Rgb& value = parameters.values[index];
    const bool isGrey = value == Rgb(value.x);
    if (isGrey && one.id == last) continue;
    last = one.id;
    sentence += (sentence.empty() ? "" : "; ") + std::string(one.id) +
                (isGrey ? "" : std::string(" (") + channelNames[std::size_t(one.channel)] + ")") + " is " +
                text(one.given) + ", expected " + text(parameter.hardMin) + " to " + text(parameter.hardMax) +
                (parameter.unit.empty() ? "" : " " + std::string(parameter.unit));
  }
  if (!sentence.empty()) throw Error(sentence);
}

ParameterValues blended(const ModelSpec& spec, std::span<const ParameterValues> ends, std::span<const double> weights) {
  assert(!ends.empty() && ends.size() == weights.size());
  if (const auto whole = indexOfFullWeight(weights)) return ends[*whole];
  ParameterValues result = ends[0];
  std::vector<double> values(ends.size());
  for (std::size_t p = 0; p < spec.parameters.size(); ++p) {
    const ParameterSpec& parameter = spec.parameters[p];
    for (int channel = 0; channel < 3; ++channel) {
      for (std::size_t i = 0; i < ends.size(); ++i) values[i] = ends[i].values[p][channel];
      if (!parameter.choices.empty() && !std::equal(values.begin() + 1, values.end(), values.begin()))
        throw Error("the choices of " + std::string(parameter.id) + " differ; they cannot be blended");
      result.values[p][channel] = blend(parameter, values, weights);
    }
  }
  return result;
}

ModelBrdf::ModelBrdf(const Model& model, ParameterValues parameters)
    : model_(model), parameters_(std::move(parameters)), brdf_(model.instantiate(parameters_)) {}

}  // namespace gonio::models
