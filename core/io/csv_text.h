// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/types.h"

namespace gonio::io {

// CSV tables, as written by hand or by spreadsheets.

/// CSV with a header line of column names. Ignores a byte order mark, empty lines, and spaces and quotes around fields;
/// line ends may be "\n", "\r\n" or "\r". Lines that begin with # are comments. The separator of the header is the
/// most frequent of comma, semicolon and tab, or spaces if there is none; rows may have another one of these, if it
/// gives as many fields as there are names. Numbers may have decimal commas in fields that do not end at commas. A
/// quoted field may contain the separator, and quotes as "", but not a line end. Fields that csvField() protects from
/// spreadsheets are read as they were.
struct CsvText {
  struct Row {
    std::size_t line = 0;  ///< from 1
    std::vector<std::string> fields;
  };

  std::vector<std::string> comments;  ///< without # and surrounding spaces
  std::size_t headerLine = 0;         ///< number of the header line, from 1; 0: the table has no header
  std::vector<std::string> names;     ///< names of the columns, in lower case
  std::vector<Row> rows;              ///< each with one field per name
  char separator = ',';               ///< of the rows
  bool hasDecimalCommas = false;

  /// For notes: "separated by semicolons, decimal commas".
  std::string notationText() const;
  /// Index of the column of a name, if it exists.
  std::optional<std::size_t> column(std::string_view name) const;
  /// Index of the column of a name. @throws Error that names the column and lists those of the table.
  std::size_t requiredColumn(std::string_view name) const;

  /// A field as a finite number, in decimal notation. @throws Error that names line and column.
  double number(const Row& row, std::size_t column) const;
  /// A field as an integer. @throws Error as number().
  int integer(const Row& row, std::size_t column) const;
};

/// @param namesWithoutHeader names of the first columns of a table without header, i.e. if the first field of the first
/// line is a number; further columns are named by their number. Empty: the first line must be a header.
/// @param firstLine number of the text's first line in its file, for errors.
/// @throws Error that names the line, if the number of fields of a row differs from the number of names (empty fields
/// at the end of a row are ignored), a name occurs twice, there are no names, or some numbers have decimal commas and
/// others decimal points.
CsvText readCsvText(std::string_view text, std::span<const std::string_view> namesWithoutHeader = {},
                    std::size_t firstLine = 1);

/// A text as a field, read back by readCsvText() without the spaces around it: plainText(), in quotes if it contains a
/// separator or a quote (RFC 4180). An apostrophe precedes a text that spreadsheets would calculate, because it
/// begins with = + - or @, and one that would be a comment; also after a semicolon, at which some spreadsheets split
/// lines. Not for numbers.
std::string csvField(std::string_view text);

/// A comment line with its line end: "# " and plainText(). An apostrophe precedes each part after a comma or a
/// semicolon that spreadsheets, which know no comments, would calculate or read as the begin of a quoted field.
std::string csvComment(std::string_view text);

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

/// The text of a file, for parsers of tables. @throws Error if it cannot be read or has more than 16 MiB; it does not
/// name the file.
std::string readText(const std::filesystem::path& path);

/// The line of a row for messages, e.g. "line 7".
std::string lineText(const CsvText::Row& row);

/// A number with at most `decimals` decimal places and no trailing zeros.
std::string decimalText(double value, int decimals);

// The columns of a table that contain a colour.

/// A linear sRGB value as the sum of columns times weights.
struct ColourColumns {
  std::vector<std::size_t> columns;
  std::vector<Rgb> weights;

  bool empty() const { return columns.empty(); }
  /// The value of a row; channels can be negative (colours outside the sRGB gamut, noise). @throws Error that names
  /// line and column if a field or the sum is not a finite number.
  Rgb value(const CsvText& csv, const CsvText::Row& row) const;
};

/// The wavelength in nm that a column name states, from 100 to 3000: "550", "550nm", "550.5 nm", "0.55um", "0.55 µm".
/// Empty for other names.
std::optional<double> wavelengthOf(const std::string& name);

/// The columns named by wavelengths, in any order, with spectrumWeights(); empty if there are fewer than three.
/// @throws Error if two columns have the same wavelength, or none is visible.
ColourColumns wavelengthColumns(const CsvText& csv);

/// The columns r, g and b. @throws Error that names a missing one.
ColourColumns rgbColumns(const CsvText& csv);

}  // namespace gonio::io
