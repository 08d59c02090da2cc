// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/types.h"

namespace gonio::io {

/// Writes a CSV table field by field, with commas, line ends "\n" and decimal points. All CSV files are written by it.
class CsvWriter {
 public:
  /// A line of csvComment().
  void comment(std::string_view text);
  /// csvField().
  CsvWriter& text(std::string_view text);
  CsvWriter& texts(std::initializer_list<std::string_view> texts);
  /// The fewest digits that read back to the same double; nothing if NaN.
  CsvWriter& number(double value);
  /// Its three channels, as number().
  CsvWriter& colour(const Rgb& value);
  CsvWriter& integer(int value);
  /// A number in the caller's format, or another text without commas and quotes that spreadsheets may calculate.
  CsvWriter& literal(std::string_view text);
  void endLine();

  const std::string& str() const { return text_; }

 private:
  std::string text_;
  bool isFirst_ = true;  ///< whether the next field is the first one of its line
};

struct CsvColumn {
  std::string title;                    ///< name and unit, e.g. "measured [1/sr]"
  std::vector<double> values;           ///< NaN becomes an empty field
  std::vector<std::string> texts = {};  ///< if not empty, used instead of `values`
  std::size_t rows() const { return texts.empty() ? values.size() : texts.size(); }
};

/// A table for other programs: comments, a line of titles, then one line per row.
struct CsvTable {
  std::vector<std::string> comments;
  std::vector<CsvColumn> columns;  ///< all with the same number of rows
};

std::string toCsv(const CsvTable& table);

}  // namespace gonio::io
