// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace gonio {

/// A text with A to Z converted to lower case, independent of the locale.
inline std::string lowerCase(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = char(c + 32);
  return text;
}

/// The shortest text that identifies a number of its type, for messages: "0.1", "-1e-09", "nan".
template <std::floating_point Number>
std::string numberText(Number value) {
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// A number with `digits` significant digits for people; "undefined" for NaN, "infinite" for infinities.
std::string shortText(double value, int digits = 4);

// Text of unknown origin, such as the names in files and documents, as text of a file that Gonio writes.

/// Stands for a byte that is not UTF-8.
inline constexpr char32_t replacementCharacter = 0xfffd;

/// A character of UTF-8 text.
struct Utf8Character {
  char32_t code = replacementCharacter;
  std::size_t bytes = 1;  ///< in the text

  /// Whether it is neither a byte that is not UTF-8, nor a character that has no place in a line: a control character
  /// (including DEL and U+0080 to U+009F), a separator of lines or paragraphs (U+2028, U+2029), or U+FFFE or U+FFFF,
  /// which XML excludes.
  bool isPlain() const;
};

/// The first character of a text that is not empty. A byte that is not UTF-8, such as one of an overlong form or of a
/// surrogate, is a replacementCharacter of one byte.
Utf8Character firstCharacter(std::string_view text);

/// A text as one line of valid UTF-8, which XML 1.0, JSON, Python, GLSL and LaTeX accept. Control characters, line ends
/// and separators become spaces, bytes that are not UTF-8 become U+FFFD. Plain text is unchanged.
std::string plainText(std::string_view text);

/// plainText() for the content of an XML element, or for an attribute in double quotes.
std::string xmlText(std::string_view text);

}  // namespace gonio
