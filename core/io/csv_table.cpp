// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/csv_table.h"

#include <charconv>
#include <cmath>

#include "core/io/csv_text.h"

namespace gonio::io {

void CsvWriter::comment(std::string_view text) { text_ += csvComment(text); }

CsvWriter& CsvWriter::text(std::string_view text) { return literal(csvField(text)); }

CsvWriter& CsvWriter::texts(std::initializer_list<std::string_view> texts) {
  for (const std::string_view field : texts) text(field);
  return *this;
}

CsvWriter& CsvWriter::number(double value) {
  if (std::isnan(value)) return literal("");
  char digits[32];
  return literal({digits, std::to_chars(digits, digits + sizeof digits, value).ptr});
}

CsvWriter& CsvWriter::colour(const Rgb& value) { return number(value.x).number(value.y).number(value.z); }

CsvWriter& CsvWriter::integer(int value) { return literal(std::to_string(value)); }

CsvWriter& CsvWriter::literal(std::string_view text) {
  if (!isFirst_) text_ += ',';
  isFirst_ = false;
  text_ += text;
  return *this;
}

void CsvWriter::endLine() {
  text_ += '\n';
  isFirst_ = true;
}

std::string toCsv(const CsvTable& table) {
  CsvWriter csv;
  for (const std::string& comment : table.comments) csv.comment(comment);
  for (const CsvColumn& column : table.columns) csv.text(column.title);
  csv.endLine();
  const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().rows();
  for (std::size_t row = 0; row < rows; ++row) {
    for (const CsvColumn& column : table.columns)
      column.texts.empty() ? csv.number(column.values[row]) : csv.text(column.texts[row]);
    csv.endLine();
  }
  return csv.str();
}

}  // namespace gonio::io
