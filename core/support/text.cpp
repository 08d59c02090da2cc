// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/support/text.h"

#include <cmath>
#include <cstdio>

namespace gonio {

std::string shortText(double value, int digits) {
  if (std::isnan(value)) return "undefined";
  if (std::isinf(value)) return "infinite";
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

Utf8Character firstCharacter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return {first, 1};
  if (first < 0xc2 || first > 0xf4) return {};
  const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  char32_t code = first & (0xffu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  const bool isOverlong = code < (bytes == 4 ? 0x10000u : bytes == 3 ? 0x800u : 0x80u);
  const bool isSurrogate = code >= 0xd800 && code < 0xe000;
  if (isOverlong || isSurrogate || code > 0x10ffff) return {};
  return {code, bytes};
}

bool Utf8Character::isPlain() const {
  if (code == replacementCharacter) return bytes > 1;
  const bool isControl = code < 0x20 || (code >= 0x7f && code < 0xa0);
  return !isControl && code != 0x2028 && code != 0x2029 && code != 0xfffe && code != 0xffff;
}

std::string plainText(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    if (character.isPlain())
      plain += text.substr(0, character.bytes);
    else
      plain += character.code == replacementCharacter ? "\xef\xbf\xbd" : " ";
    text.remove_prefix(character.bytes);
  }
  return plain;
}

std::string xmlText(std::string_view text) {
  std::string result;
  for (const char c : plainText(text)) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

}  // namespace gonio
