// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace gonio {

/// What a JSON value is, short enough for an error text: 'the text "ggx"', 'the number 3', 'an object'.
std::string describeJson(const nlohmann::json& value);

/// Takes members out of a JSON object. Every error names the member, what was found and what was expected:
/// "edits[0].strength: found the text "x", expected a number from 0 to 1". Members that nobody asks for are left alone
/// unless expectOnly() is called.
class JsonObject {
 public:
  /// @param where the object's own place, for the errors; "" at the root. `value` must live on.
  /// @throws Error when it is no object.
  JsonObject(const nlohmann::json& value, std::string where);

  /// The place of a member: "edits[0].strength".
  std::string place(std::string_view key) const;
  bool contains(std::string_view key) const { return value_.contains(key); }

  /// @throws Error naming a member that is not among `known`, for files that people write by hand: a misspelt member
  /// would go unnoticed.
  void expectOnly(std::initializer_list<std::string_view> known) const;

  // All throw Error when the member is absent or something else.
  const nlohmann::json& member(std::string_view key, std::string_view expected) const;
  std::string text(std::string_view key) const;
  bool flag(std::string_view key) const;
  /// A finite number in a closed range.
  double number(std::string_view key, double min, double max) const;
  JsonObject object(std::string_view key) const;
  const nlohmann::json& array(std::string_view key) const;

  /// @throws Error with the member's place, what was found and `expected`.
  [[noreturn]] void fail(std::string_view key, std::string_view expected) const;

 private:
  const nlohmann::json& value_;
  std::string where_;
};

}  // namespace gonio
