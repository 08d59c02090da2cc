// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/json_text.h"

#include <algorithm>

#include "core/support/error.h"
#include "core/support/json_object.h"
#include "core/support/text.h"

namespace gonio::io {

namespace {

/// Messages quote what was read last, which may be the whole text.
std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 200;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    if (character.code == replacementCharacter && character.bytes == 1) return false;
    text.remove_prefix(character.bytes);
  }
  return true;
}

/// @throws Error for the first text of a value that is not UTF-8. @param place of the value in its document.
template <typename Json>
void expectUtf8(const Json& value, const std::string& place) {
  if (value.is_string() && !isUtf8(value.template get_ref<const std::string&>()))
    throw Error(place + ": found " + describeJson(value) + ", expected text in UTF-8, the encoding of JSON");
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i) expectUtf8(value[i], place + "[" + std::to_string(i) + "]");
  if (value.is_object())
    for (const auto& member : value.items())
      expectUtf8(member.value(), place.empty() ? member.key() : place + "." + member.key());
}

template <typename Json>
std::string replacedText(const Json& value, int indent) {
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

nlohmann::json parseJson(std::string_view text) {
  using Event = nlohmann::json::parse_event_t;
  const auto limitDepth = [](int depth, Event event, const nlohmann::json&) {
    if ((event == Event::array_start || event == Event::object_start) && depth >= maxJsonDepth)
      throw Error("found JSON nested deeper than " + std::to_string(maxJsonDepth) + " levels, the limit");
    return true;
  };
  try {
    return nlohmann::json::parse(text, limitDepth);
  } catch (const nlohmann::json::out_of_range& error) {
    const std::string what = error.what();
    throw Error("found a number that is too large: " + shortened(what.substr(std::min(what.find('\''), what.size()))));
  } catch (const nlohmann::json::exception& error) {
    throw Error("found text that is not JSON (" + shortened(error.what()) + ")");
  }
}

std::string jsonText(const nlohmann::json& value, int indent) { return replacedText(value, indent); }
std::string jsonText(const nlohmann::ordered_json& value, int indent) { return replacedText(value, indent); }

std::string exactJsonText(const nlohmann::json& value, int indent) {
  expectUtf8(value, "");
  return replacedText(value, indent);
}

std::string exactJsonText(const nlohmann::ordered_json& value, int indent) {
  expectUtf8(value, "");
  return replacedText(value, indent);
}

}  // namespace gonio::io
