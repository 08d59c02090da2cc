// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/io/byte_source.h"

namespace gonio::io {

namespace {

constexpr std::size_t headBytes = std::size_t(1) << 16;
constexpr std::size_t shownCharacters = 60;
constexpr std::string_view blank = " \t", separators = " \t,;";

std::string_view withoutMargins(std::string_view text) {
  const auto begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

/// Bytes below the space other than white space; those beyond 127 may be letters of names.
bool isControl(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r' && byte != '\f';
}

}  // namespace

void TextLine::fail(const std::string& expected) const {
  throw Error("line " + std::to_string(number) + ": found '" + std::string(text.substr(0, shownCharacters)) +
              (text.size() > shownCharacters ? "..'" : "'") + ", expected " + expected);
}

std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::optional<TextLine> TextLines::next() {
  while (!rest_.empty()) {
    const auto end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view line = withoutMargins(rest_.substr(0, end));
    rest_.remove_prefix(end);
    rest_.remove_prefix(std::min<std::size_t>(rest_.starts_with("\r\n") ? 2 : 1, rest_.size()));
    ++number_;
    if (!line.empty()) return TextLine{number_, line};
  }
  return std::nullopt;
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t begin = 0; (begin = line.find_first_not_of(separators, begin)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    result.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return result;
}

std::optional<double> finiteNumber(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<double> finiteNumbers(const TextLine& line) {
  std::vector<double> result;
  for (const std::string_view word : words(line.text)) {
    const auto value = finiteNumber(word);
    if (!value)
      throw Error("line " + std::to_string(line.number) + ": found '" + std::string(word.substr(0, shownCharacters)) +
                  "', expected a finite number");
    result.push_back(*value);
  }
  return result;
}

std::string textHead(const ByteSource& source, const std::string& expected) {
  std::string head(std::size_t(std::min<std::uint64_t>(source.size(), headBytes)), '\0');
  source.readAt(0, std::as_writable_bytes(std::span(head)));
  if (head.empty()) throw FormatMismatch("an empty file", expected);
  if (std::ranges::any_of(head, isControl)) throw FormatMismatch("bytes that are not text", expected);
  return head;
}

std::string allText(const ByteSource& source, std::uint64_t maxBytes) {
  const std::vector<std::byte> bytes = source.readAll(maxBytes);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace gonio::io
