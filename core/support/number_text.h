// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <charconv>
#include <concepts>
#include <string>

namespace gonio {

/// The shortest text that identifies a number of its type, for messages: "0.1", "-1e-09", "nan".
template <std::floating_point Number>
std::string numberText(Number value) {
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

}  // namespace gonio
