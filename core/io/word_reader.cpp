// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/word_reader.h"

#include <algorithm>
#include <cmath>

#include "core/support/error.h"

namespace gonio::io {

namespace {

/// A digit and a separator.
constexpr std::size_t minBytesOfNumber = 2;

}  // namespace

std::string_view WordReader::next() {
  while (words_.empty()) {
    const auto line = lines_.next();
    if (!line) return {};
    if (line->text.starts_with('#')) continue;
    words_ = words(line->text);
    std::ranges::reverse(words_);
  }
  const std::string_view result = words_.back();
  words_.pop_back();
  return result;
}

std::string_view WordReader::word(const char* what) {
  const std::string_view result = next();
  if (result.empty()) throw Error("line " + std::to_string(lines_.number()) + ": the file ends, expected " + what);
  return result;
}

double WordReader::number(const char* what) {
  const std::string_view text = word(what);
  const auto value = finiteNumber(text);
  if (!value) fail(text, std::string("a finite number (") + what + ")");
  return *value;
}

std::size_t WordReader::count(const char* what) {
  const std::string_view text = word(what);
  const auto value = finiteNumber(text);
  const std::size_t most = lines_.bytesLeft() / minBytesOfNumber + words_.size() + 1;
  if (!value || !(*value >= 1) || *value != std::floor(*value) || *value > double(most))
    fail(text, std::string("the number of values that follow (") + what + ")");
  return std::size_t(*value);
}

std::vector<double> WordReader::numbers(std::size_t numbers, const char* what) {
  const std::size_t most = lines_.bytesLeft() / minBytesOfNumber + words_.size() + 1;
  if (numbers > most)
    throw Error("line " + std::to_string(lines_.number()) + ": the rest of the file has room for at most " +
                std::to_string(most) + " numbers, expected " + std::to_string(numbers) + " (" + what + ")");
  std::vector<double> result(numbers);
  for (double& value : result) value = number(what);
  return result;
}

void WordReader::fail(std::string_view word, const std::string& expected) const {
  TextLine{lines_.number(), word}.fail(expected);
}

}  // namespace gonio::io
