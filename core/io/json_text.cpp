// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/json_text.h"

#include <algorithm>

#include "core/support/error.h"

namespace gonio::io {

namespace {

/// Messages quote what was read last, which may be the whole text.
std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 200;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
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

}  // namespace gonio::io
