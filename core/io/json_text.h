// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace gonio::io {

/// Maximum nesting depth of arrays and objects in JSON text.
inline constexpr int maxJsonDepth = 64;

/// Parses JSON, with or without a byte order mark. Text deeper than maxJsonDepth is rejected, because copying,
/// comparing and destroying values is recursive: a few megabytes of brackets would exhaust the stack. @throws Error
/// that states the limit or the fault of the text; it names no file.
nlohmann::json parseJson(std::string_view text);

/// A value as JSON text. Bytes of its texts that are not UTF-8 become U+FFFD. @param indent spaces per level; -1: one
/// line.
std::string jsonText(const nlohmann::json& value, int indent = -1);
std::string jsonText(const nlohmann::ordered_json& value, int indent = -1);

/// The same for files whose texts, such as paths, must be read back unchanged. @throws Error that states the place of a
/// text that is not UTF-8, e.g. "edits[0].name", and the text.
std::string exactJsonText(const nlohmann::json& value, int indent = -1);
std::string exactJsonText(const nlohmann::ordered_json& value, int indent = -1);

}  // namespace gonio::io
