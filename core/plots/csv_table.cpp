// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gonio::plots {

namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void append(std::string& text, double value) {
  if (std::isnan(value)) return;
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

}  // namespace

std::string toCsv(const CsvTable& table) {
  std::string text;
  for (const std::string& comment : table.comments) text += "# " + oneLine(comment) + "\n";
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += (i ? "," : "") + quoted(table.columns[i].title);
  text += "\n";
  const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().rows();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (i) text += ",";
      const CsvColumn& column = table.columns[i];
      if (column.texts.empty())
        append(text, column.values[row]);
      else
        text += quoted(column.texts[row]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace gonio::plots
