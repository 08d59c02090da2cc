// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace gonio {

/// A short description of a JSON value for error messages: 'the text "ggx"', 'the number 3', 'an object'.
std::string describeJson(const nlohmann::json& value);

/// Reads members of a JSON object. Every error states the member, what was found and what was expected:
/// "edits[0].strength: found the text "x", expected a number from 0 to 1". Other members are ignored unless
/// expectOnly() is called.
class JsonObject {
 public:
  /// @param value must outlive this object. @param where the object's path in its document, for errors; "" at the root.
  /// @throws Error if `value` is not an object.
  JsonObject(const nlohmann::json& value, std::string where);

  /// The path of a member in its document, e.g. "edits[0].strength".
  std::string place(std::string_view key) const;
  bool contains(std::string_view key) const { return value_.contains(key); }

  /// Checks for unknown members, to find misspelt ones in files that are written by hand. @throws Error that names a
  /// member which is not in `known`.
  void expectOnly(std::initializer_list<std::string_view> known) const;

  // All throw Error if the member is missing or has another type.
  const nlohmann::json& member(std::string_view key, std::string_view expected) const;
  std::string text(std::string_view key) const;
  bool flag(std::string_view key) const;
  /// A finite number in a closed range.
  double number(std::string_view key, double min, double max) const;
  /// Three numbers, such as a position or a colour, of at most maxOfTriple in size.
  std::array<double, 3> triple(std::string_view key, bool mayBeNegative = true) const;
  static constexpr double maxOfTriple = 1e6;
  JsonObject object(std::string_view key) const;
  const nlohmann::json& array(std::string_view key) const;

  /// @throws Error that states the member's path, what was found and `expected`.
  [[noreturn]] void fail(std::string_view key, std::string_view expected) const;

 private:
  const nlohmann::json& value_;
  std::string where_;
};

}  // namespace gonio
