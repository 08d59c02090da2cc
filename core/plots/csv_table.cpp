// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/csv_table.h"

#include <charconv>
#include <cmath>

#include "core/io/csv_text.h"

namespace gonio::plots {

namespace {

void append(std::string& text, double value) {
  if (std::isnan(value)) return;
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

}  // namespace

std::string toCsv(const CsvTable& table) {
  std::string text;
  for (const std::string& comment : table.comments) text += io::csvComment(comment);
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += (i ? "," : "") + io::csvField(table.columns[i].title);
  text += "\n";
  const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().rows();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (i) text += ",";
      const CsvColumn& column = table.columns[i];
      if (column.texts.empty())
        append(text, column.values[row]);
      else
        text += io::csvField(column.texts[row]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace gonio::plots
