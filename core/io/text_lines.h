// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/byte_source.h"

/// Parsing of text formats of measuring instruments: lines of words and numbers. For tables with named columns see
/// csv_text.h.
namespace gonio::io {

/// A line of a text with its number.
struct TextLine {
  std::size_t number = 0;  ///< from 1
  std::string_view text;   ///< without line end and surrounding spaces and tabs

  /// @throws Error "line 7: found 'a b', expected ...". Long lines are shortened.
  [[noreturn]] void fail(const std::string& expected) const;
};

/// Text without the byte order mark (U+FEFF in UTF-8) that some editors and spreadsheets write before it.
std::string_view withoutByteOrderMark(std::string_view text);

/// Iterates over the lines of a text that are not empty. Line ends: "\n", "\r\n", "\r". A byte order mark is skipped.
class TextLines {
 public:
  /// @param text must outlive the lines.
  explicit TextLines(std::string_view text) : rest_(withoutByteOrderMark(text)) {}
  std::optional<TextLine> next();
  /// Number of bytes left: an upper bound for how many numbers can follow.
  std::size_t bytesLeft() const { return rest_.size(); }
  /// Number of the last line read; 0 before the first.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// A line without the comment that begins with # in it.
std::string_view withoutComment(std::string_view line);

/// How the numbers of a text are written. Numbers are separated by spaces, tabs and semicolons, and by commas unless
/// these are the decimal sign.
struct NumberNotation {
  bool hasDecimalCommas = false;
  /// Not empty if the text can be read in two ways: what was found where, and what to write instead.
  std::string ambiguity = {};

  std::string_view separators() const { return hasDecimalCommas ? " \t;" : " \t,;"; }
  /// For notes: "decimal commas" or "decimal points".
  std::string text() const { return hasDecimalCommas ? "decimal commas" : "decimal points"; }
  /// @throws Error with the ambiguity, if there is one.
  const NumberNotation& unambiguous() const;
};

/// The notation of the numbers in a text, from its lines of numbers with at most one other word before them. Commas are
/// decimal signs if there are commas between two digits, other separators between the numbers, and no decimal points.
/// Ambiguous are commas between two digits beside a decimal point where other separators are used too, beside commas
/// that separate, and with numbers like 063 where only commas separate ("0,063"). O(length of the text).
NumberNotation notationOf(std::string_view text);

/// The words of a line, separated as in a notation.
std::vector<std::string_view> words(std::string_view line, const NumberNotation& notation = {});

/// A word as a finite number in decimal notation; empty if it is not one.
std::optional<double> finiteNumber(std::string_view word, const NumberNotation& notation = {});
/// All words of a line as numbers. @throws Error that names the line and a word which is not a finite number.
std::vector<double> finiteNumbers(const TextLine& line, const NumberNotation& notation = {});

/// The first 64 KiB of a source as text, to recognise formats. @throws FormatMismatch that states `expected`, if there
/// are bytes that do not occur in text.
std::string textHead(const ByteSource& source, const std::string& expected);
/// All bytes of a source as text. @throws Error if there are more than `maxBytes`.
std::string allText(const ByteSource& source, std::uint64_t maxBytes = std::uint64_t(1) << 26);

}  // namespace gonio::io
