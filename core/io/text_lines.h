// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/byte_source.h"

/// Text formats of measuring instruments: lines of words and numbers (tables with named columns: csv_text.h).
namespace gonio::io {

/// A line of a text with its number, for errors.
struct TextLine {
  std::size_t number = 0;  ///< from 1
  std::string_view text;   ///< without line end, spaces and tabs about it

  /// "line 7: found 'a b', expected ..". A long line is cut.
  [[noreturn]] void fail(const std::string& expected) const;
};

/// The lines of a text that are not empty, one after another. Ends: "\n", "\r\n", "\r".
class TextLines {
 public:
  /// @param text that outlives the lines.
  explicit TextLines(std::string_view text) : rest_(text) {}
  std::optional<TextLine> next();
  /// How many bytes are left: what follows holds at most as many numbers.
  std::size_t bytesLeft() const { return rest_.size(); }
  /// Number of the line that was read last; 0 before the first.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// The words of a line: what stands between spaces, tabs, commas and semicolons.
std::vector<std::string_view> words(std::string_view line);

/// A word as a finite number, in decimal notation; none where it is not one.
std::optional<double> finiteNumber(std::string_view word);
/// All words of a line as numbers. @throws Error naming the line and the word where one is not a finite number.
std::vector<double> finiteNumbers(const TextLine& line);

/// The first 64 KiB of a source as text, for sniffers. @throws FormatMismatch where it holds bytes that no text has,
/// stating `expected`.
std::string textHead(const ByteSource& source, const std::string& expected);
/// All of it. @throws Error where it has more bytes.
std::string allText(const ByteSource& source, std::uint64_t maxBytes = std::uint64_t(1) << 26);

}  // namespace gonio::io
