// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/io/text_lines.h"

namespace gonio::io {

/// Reads the words of a text in sequence, across lines; lines that begin with # are ignored.
class WordReader {
 public:
  /// @param text must outlive the reader.
  explicit WordReader(std::string_view text) : lines_(text) {}

  /// The next word; empty at the end of the text.
  std::string_view next();
  /// The next word. @throws Error that names the line and `what` at the end of the text.
  std::string_view word(const char* what);
  /// The next word as a number. @throws Error that names the line if it is not a finite number.
  double number(const char* what);
  /// The next word as a count >= 1, at most the number of values that the rest of the text can contain. @throws as
  /// number().
  std::size_t count(const char* what);
  /// The next `numbers` words as numbers. Checks first that the rest of the text can contain so many. @throws as
  /// number().
  std::vector<double> numbers(std::size_t numbers, const char* what);
  /// Skips the rest of the line.
  void skipLine() { words_.clear(); }

  /// @throws Error "line 7: found 'word', expected ...".
  [[noreturn]] void fail(std::string_view word, const std::string& expected) const;

 private:
  TextLines lines_;
  std::vector<std::string_view> words_;  ///< of the line, the next one last
};

}  // namespace gonio::io
