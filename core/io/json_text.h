// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace gonio::io {

/// Maximum nesting depth of arrays and objects in JSON text.
inline constexpr int maxJsonDepth = 64;

/// Parses JSON, with or without a byte order mark. Text deeper than maxJsonDepth is rejected, because copying,
/// comparing and destroying values is recursive: a few megabytes of brackets would exhaust the stack. @throws Error
/// that states the limit or the fault of the text; it names no file.
nlohmann::json parseJson(std::string_view text);

}  // namespace gonio::io
