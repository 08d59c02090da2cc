// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Tables as people and spreadsheets write them.
namespace gonio::io {

/// CSV with a line of names. A byte order mark, "\r\n" or "\r" at line ends, spaces and quotes about fields and empty
/// lines are passed over; lines that begin with # are comments. Fields end at commas, or where the line of names has
/// none, at semicolons (then a number may have a decimal comma) or at tabs. A quoted field holds no separator.
struct CsvText {
  struct Row {
    std::size_t line = 0;  ///< from 1
    std::vector<std::string> fields;
  };

  std::vector<std::string> comments;  ///< without # and the spaces about them
  std::size_t namesLine = 0;
  std::vector<std::string> names;  ///< of the columns, in lower case
  std::vector<Row> rows;           ///< each of as many fields as there are names
  char separator = ',';

  /// Where a column of the name stands.
  std::optional<std::size_t> column(std::string_view name) const;
  /// The same. @throws Error naming the column and those there are.
  std::size_t neededColumn(std::string_view name) const;

  /// A field as a finite number, in decimal notation. @throws Error naming line and column.
  double number(const Row& row, std::size_t column) const;
  /// A field as a whole number. @throws Error likewise.
  int integer(const Row& row, std::size_t column) const;
};

/// @param namesWithoutHeader of the first columns of a table whose first line holds a number in its first field;
/// further columns are named by their number. Empty where the first line has to be one of names.
/// @param firstLine number of the text's first line in its file, for errors.
/// @throws Error naming the line where a row has another number of fields than there are names (fields that are empty
/// at the end of a row are passed over), where a name stands twice, and where there are no names.
CsvText readCsvText(std::string_view text, std::span<const std::string_view> namesWithoutHeader = {},
                    std::size_t firstLine = 1);

/// The text of a file, for parsers of tables. @throws Error where it has more than 16 MiB; it names no file.
std::string readText(const std::filesystem::path& path);

/// "line 7".
std::string lineText(const CsvText::Row& row);

/// A number with at most `decimals` places and no trailing zeros.
std::string decimalText(double value, int decimals);

}  // namespace gonio::io
