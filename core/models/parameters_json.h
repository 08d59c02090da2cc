// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/models/model.h"

namespace gonio::models {

/// {"diffuse": [0.5, 0.4, 0.3], "roughness": 0.2}: every parameter by its id; three values if the spec says perChannel,
/// else one number. Doubles are stored without loss. @throws Error if the number of values is wrong or one is not
/// finite.
nlohmann::json parametersToJson(const ModelSpec& spec, const ParameterValues& parameters);

/// Inverse of parametersToJson(). A missing parameter has its default, so that documents remain valid if a model gets
/// new parameters; unknown parameters are errors. A single number means three equal ones; values outside the hard range
/// are not changed (Model::instantiate() clamps them). @param where the object's path in its document for errors, e.g.
/// "edits[0].fitted". @throws Error that names the parameter, what was found and what was expected.
ParameterValues parametersFromJson(const ModelSpec& spec, const nlohmann::json& json, const std::string& where);

}  // namespace gonio::models
