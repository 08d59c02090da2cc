// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <nlohmann/json.hpp>

namespace gonio::editing {

/// Converts the JSON of an edit from a document of `version` to EditDocument::currentVersion: the same numbers under
/// current names. JSON that is not an edit is returned unchanged; the reader reports it.
nlohmann::json migratedEdit(nlohmann::json edit, int version);

}  // namespace gonio::editing
