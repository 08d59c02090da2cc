// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/support/json_object.h"

#include <algorithm>

#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio {

namespace {
constexpr std::size_t maxDescribed = 60;

std::string formatNumber(double value) { return nlohmann::json(value).dump(); }
}  // namespace

std::string describeJson(const nlohmann::json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  if (value.is_null()) return "null";
  std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (text.size() > maxDescribed) text = text.substr(0, maxDescribed) + "...";
  text = plainText(text);  // also of a character that is cut
  if (value.is_string()) return "the string " + text;
  return value.is_number() ? "the number " + text : text;
}

JsonObject::JsonObject(const nlohmann::json& value, std::string where) : value_(value), where_(std::move(where)) {
  if (!value_.is_object())
    throw Error((where_.empty() ? "the document" : where_) + ": found " + describeJson(value) + ", expected an object");
}

std::string JsonObject::place(std::string_view key) const {
  return where_.empty() ? std::string(key) : where_ + "." + std::string(key);
}

void JsonObject::fail(std::string_view key, std::string_view expected) const {
  const auto found = value_.find(key);
  throw Error(place(key) + ": found " + (found == value_.end() ? "nothing" : describeJson(*found)) + ", expected " +
              std::string(expected));
}

const nlohmann::json& JsonObject::member(std::string_view key, std::string_view expected) const {
  const auto found = value_.find(key);
  if (found == value_.end()) fail(key, expected);
  return *found;
}

void JsonObject::expectOnly(std::initializer_list<std::string_view> known) const {
  std::string expected = "one of ";
  for (const std::string_view name : known) expected += (expected.ends_with("of ") ? "" : ", ") + std::string(name);
  for (const auto& item : value_.items())
    if (std::ranges::find(known, std::string_view(item.key())) == known.end())
      throw Error(place(item.key()) + ": unknown member, expected " + expected);
}

std::string JsonObject::text(std::string_view key) const {
  const nlohmann::json& found = member(key, "a string");
  if (!found.is_string()) fail(key, "a string");
  return found.get<std::string>();
}

bool JsonObject::flag(std::string_view key) const {
  const nlohmann::json& found = member(key, "true or false");
  if (!found.is_boolean()) fail(key, "true or false");
  return found.get<bool>();
}

double JsonObject::number(std::string_view key, double min, double max) const {
  const std::string expected = "a number from " + formatNumber(min) + " to " + formatNumber(max);
  const nlohmann::json& found = member(key, expected);
  if (!found.is_number()) fail(key, expected);
  const double value = found.get<double>();
  if (!(value >= min && value <= max)) fail(key, expected);
  return value;
}

std::array<double, 3> JsonObject::triple(std::string_view key, bool mayBeNegative) const {
  const std::string expected =
      std::string("three numbers from ") + (mayBeNegative ? "-1e6" : "0") + " to 1e6, as [1, 2, 3]";
  const nlohmann::json& found = member(key, expected);
  if (!found.is_array() || found.size() != 3) fail(key, expected);
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!found[i].is_number()) fail(key, expected);
    result[i] = found[i].get<double>();
    if (!(result[i] >= (mayBeNegative ? -maxOfTriple : 0) && result[i] <= maxOfTriple)) fail(key, expected);
  }
  return result;
}

JsonObject JsonObject::object(std::string_view key) const { return {member(key, "an object"), place(key)}; }

const nlohmann::json& JsonObject::array(std::string_view key) const {
  const nlohmann::json& found = member(key, "a list");
  if (!found.is_array()) fail(key, "a list");
  return found;
}

}  // namespace gonio
