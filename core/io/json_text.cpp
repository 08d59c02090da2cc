// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/json_text.h"

#include "core/support/error.h"

namespace gonio::io {

nlohmann::json parseJson(std::string_view text) {
  using Event = nlohmann::json::parse_event_t;
  const auto limitDepth = [](int depth, Event event, const nlohmann::json&) {
    if ((event == Event::array_start || event == Event::object_start) && depth >= maxJsonDepth)
      throw Error("found JSON nested deeper than " + std::to_string(maxJsonDepth) + " levels, the limit");
    return true;
  };
  try {
    return nlohmann::json::parse(text, limitDepth);
  } catch (const nlohmann::json::exception& error) {
    throw Error(std::string("found text that is not JSON (") + error.what() + ")");
  }
}

}  // namespace gonio::io
