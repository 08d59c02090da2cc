// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <nlohmann/json.hpp>

namespace gonio::editing {

/// An edit as EditDocument::currentVersion writes it, from one that a document of `version` holds: the same numbers
/// under today's names. What is no edit passes through, for the reader to report.
nlohmann::json migratedEdit(nlohmann::json edit, int version);

}  // namespace gonio::editing
