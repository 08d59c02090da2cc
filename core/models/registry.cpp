// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/registry.h"

#include "core/support/error.h"

namespace gonio::models {

std::span<const Model* const> allModels() {
#define GONIO_LIST_MODEL(name) &name(),
  static const Model* const models[] = {GONIO_MODELS(GONIO_LIST_MODEL)};
#undef GONIO_LIST_MODEL
  return models;
}

std::string modelsWithLobes() {
  std::string ids;
  for (const Model* model : allModels())
    if (model->hasLobes()) ids += (ids.empty() ? "" : ", ") + std::string(model->spec().id);
  return ids;
}

const Model& findModel(std::string_view id) {
  std::string known;
  for (const Model* model : allModels()) {
    if (model->spec().id == id) return *model;
    known += (known.empty() ? "" : ", ") + std::string(model->spec().id);
  }
  throw Error("found the model '" + std::string(id) + "', expected one of " + known);
}

}  // namespace gonio::models
