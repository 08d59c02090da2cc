// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/parameters_json.h"

#include <cmath>

#include "core/support/error.h"
#include "core/support/json_object.h"

namespace gonio::models {

namespace {

bool isFiniteNumber(const nlohmann::json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

Rgb valueFromJson(const ParameterSpec& parameter, const JsonObject& object) {
  if (!object.contains(parameter.id)) return Rgb(parameter.defaultValue);
  const char* expected = parameter.perChannel ? "a number or three (red, green, blue)" : "a number";
  const nlohmann::json& value = object.member(parameter.id, expected);
  if (isFiniteNumber(value)) return Rgb(value.get<double>());
  if (!parameter.perChannel || !value.is_array() || value.size() != 3) object.fail(parameter.id, expected);
  Rgb result;
  for (int channel = 0; channel < 3; ++channel) {
    if (!isFiniteNumber(value[std::size_t(channel)])) object.fail(parameter.id, expected);
    result[channel] = value[std::size_t(channel)].get<double>();
  }
  return result;
}

}  // namespace

nlohmann::json parametersToJson(const ModelSpec& spec, const ParameterValues& parameters) {
  ParameterValues checked = parameters;
  clampToHardRange(spec, checked);  // for its errors; what is written are the values as they are
  nlohmann::json json = nlohmann::json::object();
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const Rgb& value = parameters.values[i];
    nlohmann::json& target = json[std::string(spec.parameters[i].id)];
    if (spec.parameters[i].perChannel)
      target = {value.x, value.y, value.z};
    else
      target = value.x;
  }
  return json;
}

ParameterValues parametersFromJson(const ModelSpec& spec, const nlohmann::json& json, const std::string& where) {
  const JsonObject object(json, where);
  ParameterValues result;
  std::string ids;
  for (const ParameterSpec& parameter : spec.parameters) {
    result.values.push_back(valueFromJson(parameter, object));
    ids += (ids.empty() ? "" : ", ") + std::string(parameter.id);
  }
  for (const auto& [key, value] : json.items())
    if (!spec.find(key)) object.fail(key, "a parameter of the model " + std::string(spec.id) + " (" + ids + ")");
  return result;
}

}  // namespace gonio::models
