// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/io/text_lines.h"

namespace gonio::io {

/// The words of a text one after another, whatever lines they stand in; lines that begin with # are passed over.
class WordReader {
 public:
  /// @param text that outlives the reader.
  explicit WordReader(std::string_view text) : lines_(text) {}

  /// The next word; empty at the end of the text.
  std::string_view next();
  /// The next word. @throws Error naming line and `what` at the end of the text.
  std::string_view word(const char* what);
  /// @throws Error naming the line where the next word is not a finite number.
  double number(const char* what);
  /// A count from 1, for which the text that is left can have as many numbers. @throws Error likewise.
  std::size_t count(const char* what);
  /// @param numbers at most what the text that is left can hold: nothing is allocated beyond. @throws Error likewise.
  std::vector<double> numbers(std::size_t numbers, const char* what);
  /// Passes over the rest of the line.
  void skipLine() { words_.clear(); }

  /// @throws Error "line 7: found 'word', expected ..".
  [[noreturn]] void fail(std::string_view word, const std::string& expected) const;

 private:
  TextLines lines_;
  std::vector<std::string_view> words_;  ///< of the line, the next one last
};

}  // namespace gonio::io
