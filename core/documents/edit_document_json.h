// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/documents/edit_document.h"
#include "core/support/json_object.h"

/// The JSON that documents and the materials of blends share: "source" and "edits".
namespace gonio::editing {

nlohmann::json contentToJson(const EditDocument& document);
/// @param depth number of enclosing blends. @throws Error as documentFromJson().
EditDocument contentFromJson(const JsonObject& object, int version, int depth = 0);

/// The model named under "model". @throws Error that names the key.
const models::Model& modelFromJson(const JsonObject& object);

}  // namespace gonio::editing
