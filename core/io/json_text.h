// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace gonio::io {

/// Levels of lists and objects in each other that JSON text may have.
inline constexpr int maxJsonDepth = 64;

/// JSON from text. Copies, comparisons and the end of a value recurse: without the limit a few megabytes of brackets
/// exhaust the stack, so that deeper text is refused while it is read.
/// @throws Error stating the limit, or what is wrong with the text; it names no file.
nlohmann::json parseJson(std::string_view text);

}  // namespace gonio::io
