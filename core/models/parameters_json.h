// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/models/model.h"

namespace gonio::models {

/// {"diffuse": [0.5, 0.4, 0.3], "roughness": 0.2}: every parameter by its id; three values where the spec says
/// perChannel, else one number. Doubles keep every bit.
/// @throws Error when the count of values is wrong or one is not finite.
nlohmann::json parametersToJson(const ModelSpec& spec, const ParameterValues& parameters);

/// The reverse. A parameter that is not there has its default: documents written before a model got it go on opening
/// with the same numbers. Parameters that the model does not have are errors. A single number stands for three equal
/// ones; values outside the hard range are kept (Model::instantiate() clamps them).
/// @param where the object's place in its document, for the errors: "edits[0].fitted".
/// @throws Error naming the parameter, what was found and what was expected.
ParameterValues parametersFromJson(const ModelSpec& spec, const nlohmann::json& json, const std::string& where);

}  // namespace gonio::models
