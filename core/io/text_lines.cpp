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
constexpr std::string_view blank = " \t";

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

std::string_view withoutComment(std::string_view line) { return line.substr(0, line.find('#')); }

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Whether a word consists of the characters of numbers and contains a digit.
bool looksLikeNumbers(std::string_view word) {
  return std::ranges::any_of(word, isDigit) && word.find_first_not_of("0123456789+-.,eE") == std::string_view::npos;
}

/// Whether a part between commas is an integer with a zero before its first digit.
bool hasLeadingZero(std::string_view part) {
  if (part.starts_with('-') || part.starts_with('+')) part.remove_prefix(1);
  return part.size() > 1 && part[0] == '0' && std::ranges::all_of(part, isDigit);
}

/// What the words of a text say about its notation: the first words of each kind, as "'60,0' in line 4".
class NotationEvidence {
 public:
  void add(const TextLine& line) {
    const auto all = words(withoutComment(line.text), {.hasDecimalCommas = true});
    // Other lines are text, after a key perhaps.
    if (all.empty() || !std::all_of(all.begin() + 1, all.end(), looksLikeNumbers)) return;
    bool afterNumber = false;
    for (const std::string_view word : all) {
      const bool isNumber = looksLikeNumbers(word);
      if (isNumber) addWord(line, word);
      // Blanks, tabs or semicolons alone separate these two.
      if (isNumber && afterNumber && !word.starts_with(',')) otherSeparators_ = true;
      afterNumber = isNumber && !word.ends_with(',');
    }
  }

  NumberNotation notation() const {
    const std::string choices =
        "; write decimal points, or decimal commas with blanks, tabs or semicolons between the numbers";
    if (innerComma_.empty()) return {};
    if (otherSeparators_ && !point_.empty())
      return {.ambiguity = "found " + innerComma_ + " and " + point_ + ", expected one decimal sign" + choices};
    if (otherSeparators_ && manyCommas_.empty() && outerComma_.empty()) return {.hasDecimalCommas = true};
    if (!point_.empty()) return {};
    const std::string& separating = outerComma_.empty() ? leadingZero_ : outerComma_;
    if (otherSeparators_ || !separating.empty())
      return {.ambiguity = "found " + innerComma_ + (separating.empty() ? "" : " and " + separating) +
                           ", where commas may separate numbers or be decimal signs, expected one of these" + choices};
    return {};
  }

 private:
  static void note(std::string& first, const TextLine& line, std::string_view word) {
    if (first.empty())
      first = "'" + std::string(word.substr(0, shownCharacters)) + "' in line " + std::to_string(line.number);
  }
  void addWord(const TextLine& line, std::string_view word) {
    if (word.find('.') != std::string_view::npos) note(point_, line, word);
    if (word.starts_with(',') || word.ends_with(',')) note(outerComma_, line, word);
    std::size_t inner = 0;
    for (std::size_t i = 1; i + 1 < word.size(); ++i)
      inner += word[i] == ',' && isDigit(word[i - 1]) && isDigit(word[i + 1]);
    if (inner > 0) note(innerComma_, line, word);
    if (inner > 1) note(manyCommas_, line, word);
    for (std::size_t begin = 0; inner > 0 && begin < word.size();) {
      const std::size_t end = std::min(word.find(',', begin), word.size());
      if (hasLeadingZero(word.substr(begin, end - begin))) note(leadingZero_, line, word);
      begin = end + 1;
    }
  }

  std::string innerComma_, manyCommas_, outerComma_, point_, leadingZero_;
  bool otherSeparators_ = false;
};

}  // namespace

const NumberNotation& NumberNotation::unambiguous() const {
  if (!ambiguity.empty()) throw Error(ambiguity);
  return *this;
}

NumberNotation notationOf(std::string_view text) {
  NotationEvidence evidence;
  TextLines lines(text);
  while (const auto line = lines.next()) evidence.add(*line);
  return evidence.notation();
}

std::vector<std::string_view> words(std::string_view line, const NumberNotation& notation) {
  const std::string_view separators = notation.separators();
  std::vector<std::string_view> result;
  for (std::size_t begin = 0; (begin = line.find_first_not_of(separators, begin)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    result.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return result;
}

std::optional<double> finiteNumber(std::string_view word, const NumberNotation& notation) {
  std::string withPoint;
  if (notation.hasDecimalCommas) {
    withPoint = word;
    std::ranges::replace(withPoint, ',', '.');
    word = withPoint;
  }
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<double> finiteNumbers(const TextLine& line, const NumberNotation& notation) {
  std::vector<double> result;
  for (const std::string_view word : words(withoutComment(line.text), notation)) {
    const auto value = finiteNumber(word, notation);
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
  if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF"))
    throw FormatMismatch("text in UTF-16", expected + ", in UTF-8");
  if (std::ranges::any_of(head, isControl)) throw FormatMismatch("bytes that are not text", expected);
  return head;
}

std::string allText(const ByteSource& source, std::uint64_t maxBytes) {
  const std::vector<std::byte> bytes = source.readAll(maxBytes);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace gonio::io
