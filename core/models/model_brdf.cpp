// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/model_brdf.h"

namespace gonio::models {

ModelBrdf::ModelBrdf(const Model& model, ParameterValues parameters)
    : model_(model), parameters_(std::move(parameters)), brdf_(model.instantiate(parameters_)) {}

}  // namespace gonio::models
