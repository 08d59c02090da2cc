// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/csv_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>

#include "core/io/text_lines.h"
#include "core/math/colour.h"
#include "core/support/error.h"
#include "core/support/text.h"

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

namespace {

constexpr std::uint64_t maxBytes = 1 << 24;

std::string_view trimmed(std::string_view text, std::string_view characters = " \t\"") {
  const auto begin = text.find_first_not_of(characters);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(characters) - begin + 1);
}

/// Takes a line off the front.
std::string_view takeLine(std::string_view& text) {
  const auto end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  if (end == std::string_view::npos) {
    text = {};
    return line;
  }
  text.remove_prefix(end + (text.substr(end).starts_with("\r\n") ? 2 : 1));
  return line;
}

/// Whether a text, without the apostrophes before it, begins a formula of a spreadsheet (also in wide characters) or a
/// comment.
bool isSpecial(std::string_view text) {
  const auto begin = text.find_first_not_of(" '");
  if (begin == std::string_view::npos) return false;
  for (const std::string_view sign : {"#", "=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20"})
    if (text.substr(begin).starts_with(sign)) return true;
  return false;
}

/// Whether an apostrophe precedes a part of a text: one after a separator that spreadsheets would take as a cell of its
/// own, with a formula or quotes.
bool needsApostrophe(std::string_view text, std::size_t at, std::string_view separators) {
  if (at == 0 || separators.find(text[at - 1]) == std::string_view::npos) return false;
  const std::string_view part = text.substr(at);
  return isSpecial(part) || trimmed(part, " '").starts_with('"');
}

std::string withApostrophes(std::string_view text, std::string_view separators) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (needsApostrophe(text, i, separators)) result += '\'';
    result += text[i];
  }
  return result;
}

/// A field without the apostrophes that csvField() adds.
std::string withoutApostrophes(std::string_view field) {
  std::string result;
  for (std::size_t i = 0; i < field.size(); ++i)
    if (field[i] != '\'' || !(i == 0 ? isSpecial(field) : needsApostrophe(field, i, ";"))) result += field[i];
  return result;
}

struct QuotedField {
  std::string text;
  std::size_t end;  ///< position of the separator after it, or of the end of the line
};

/// The quoted field (RFC 4180) at a position of a line, if there is one.
std::optional<QuotedField> quotedField(std::string_view line, std::size_t begin, char separator) {
  std::size_t at = line.find_first_not_of(' ', begin);
  if (at == std::string_view::npos || line[at] != '"') return std::nullopt;
  std::string text;
  for (++at; at < line.size() && (line[at] != '"' || line.substr(at).starts_with("\"\"")); ++at) {
    if (line[at] == '"') ++at;
    text += line[at];
  }
  const std::size_t end = std::min(line.find_first_not_of(' ', at + 1), line.size());
  if (at == line.size() || (end < line.size() && line[end] != separator)) return std::nullopt;
  return QuotedField{std::string(trimmed(text, " \t")), end};
}

std::vector<std::string> split(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    std::size_t end = std::min(line.find(separator, begin), line.size());
    std::string field(trimmed(line.substr(begin, end - begin)));
    if (std::optional<QuotedField> quoted = quotedField(line, begin, separator)) {
      field = std::move(quoted->text);
      end = quoted->end;
    }
    fields.push_back(withoutApostrophes(field));
    begin = end + 1;
  }
  return fields;
}

/// Words between spaces; a field with a comma at its end shows that the spaces only follow commas.
std::vector<std::string> splitAtSpaces(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0; (begin = line.find_first_not_of(" \t", begin)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    fields.emplace_back(trimmed(line.substr(begin, end - begin)));
    begin = end;
  }
  return fields;
}

std::vector<std::string> fieldsOf(std::string_view line, char separator) {
  return separator == ' ' ? splitAtSpaces(line) : split(line, separator);
}

/// The most frequent one outside quotes.
char separatorOfNames(std::string_view line) {
  char result = ' ';
  std::size_t most = 0;
  for (const char separator : {',', ';', '\t'})
    if (const std::size_t count = split(line, separator).size() - 1; count > most) {
      result = separator;
      most = count;
    }
  return result;
}

template <typename Number>
std::optional<Number> parsed(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string listOf(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

void readNames(CsvText& csv, std::string_view line, std::size_t number) {
  csv.separator = separatorOfNames(line);
  csv.headerLine = number;
  for (std::string& name : fieldsOf(line, csv.separator)) csv.names.push_back(lowerCase(std::move(name)));
  // Spreadsheets fill rows up with empty fields.
  while (!csv.names.empty() && csv.names.back().empty()) csv.names.pop_back();
  for (std::size_t c = 1; c < csv.names.size(); ++c)
    if (std::find(csv.names.begin(), csv.names.begin() + std::ptrdiff_t(c), csv.names[c]) !=
        csv.names.begin() + std::ptrdiff_t(c))
      throw Error("line " + std::to_string(number) + ": found two columns '" + csv.names[c] + "', expected one");
}

/// The separator of a row of numbers that gives a number of fields, at least or exactly; `otherwise` if none does.
/// Commas come after the others: they may be decimal signs.
char separatorOfRow(std::string_view line, std::size_t count, bool isExact, char otherwise) {
  for (const char separator : {';', '\t', ' ', ','}) {
    const std::vector<std::string> fields = fieldsOf(line, separator);
    const bool followsCommas =
        separator == ' ' && std::ranges::any_of(fields, [](const std::string& field) { return field.ends_with(','); });
    if (!followsCommas && (isExact ? fields.size() == count : fields.size() >= count)) return separator;
  }
  return otherwise;
}

/// Sets the names of a table without a header: the first line is already a row.
void setNames(CsvText& csv, std::span<const std::string_view> names, std::string_view firstLine) {
  csv.separator = separatorOfRow(firstLine, std::max<std::size_t>(names.size(), 2), false, ',');
  csv.names.assign(names.begin(), names.end());
  for (const std::size_t count = fieldsOf(firstLine, csv.separator).size(); csv.names.size() < count;)
    csv.names.push_back(std::to_string(csv.names.size() + 1));
}

bool beginsWithNumber(std::string_view line) {
  return parsed<double>(trimmed(line.substr(0, line.find_first_of(",;\t ", line.find_first_not_of(' '))))).has_value();
}

/// Whether a field is a number with a decimal comma.
bool hasDecimalComma(const std::string& field) {
  const std::size_t comma = field.find(',');
  if (comma == std::string::npos || field.find_first_of(",.", comma + 1) != std::string::npos) return false;
  std::string number = field;
  number[comma] = '.';
  return parsed<double>(number).has_value();
}

bool isNumber(const std::string& field) { return parsed<double>(field) || hasDecimalComma(field); }

std::size_t countOf(const std::vector<std::string>& fields, std::size_t expected) {
  std::size_t count = fields.size();
  while (count > expected && fields[count - 1].empty()) --count;
  return count;
}

void addRow(CsvText& csv, std::string_view line, std::size_t number) {
  if (csv.rows.empty() && csv.headerLine > 0) {
    const char other = separatorOfRow(line, csv.names.size(), true, csv.separator);
    if (countOf(fieldsOf(line, csv.separator), csv.names.size()) != csv.names.size() ||
        std::ranges::all_of(fieldsOf(line, other), isNumber))
      csv.separator = other;
  }
  CsvText::Row row{number, fieldsOf(line, csv.separator)};
  row.fields.resize(countOf(row.fields, csv.names.size()));
  if (row.fields.size() != csv.names.size())
    throw Error(lineText(row) + ": found " + std::to_string(row.fields.size()) + " columns, expected " +
                std::to_string(csv.names.size()) + ": " + listOf(csv.names) +
                (csv.separator == ',' && row.fields.size() > csv.names.size()
                     ? " (if commas are decimal signs, separate the columns by semicolons, tabs or spaces)"
                     : ""));
  csv.rows.push_back(std::move(row));
}

/// One sign for all numbers: 1,234 beside 0.5 would be a thousand times as large.
void findDecimalSign(CsvText& csv) {
  std::string comma, point;
  const auto note = [](std::string& first, const CsvText::Row& row, const std::string& field) {
    if (first.empty()) first = "'" + field + "' in " + lineText(row);
  };
  for (const CsvText::Row& row : csv.rows)
    for (const std::string& field : row.fields) {
      if (hasDecimalComma(field)) note(comma, row, field);
      if (field.find('.') != std::string::npos && parsed<double>(field)) note(point, row, field);
    }
  csv.hasDecimalCommas = !comma.empty();
  if (!comma.empty() && !point.empty()) throw Error("found " + comma + " and " + point + ", expected one decimal sign");
}

[[noreturn]] void failField(const CsvText& csv, const CsvText::Row& row, std::size_t column, const char* expected) {
  throw Error(lineText(row) + ": found '" + row.fields[column] + "' for " + csv.names[column] + ", expected " +
              expected);
}

}  // namespace

std::optional<std::size_t> CsvText::column(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return std::size_t(found - names.begin());
}

std::size_t CsvText::requiredColumn(std::string_view name) const {
  if (const auto found = column(name)) return *found;
  throw Error("line " + std::to_string(headerLine) + ": found the columns " + listOf(names) + ", expected one named " +
              std::string(name));
}

std::string CsvText::notationText() const {
  return std::string("separated by ") +
         (separator == ','    ? "commas"
          : separator == ';'  ? "semicolons"
          : separator == '\t' ? "tabs"
                              : "spaces") +
         ", decimal " + (hasDecimalCommas ? "commas" : "points");
}

double CsvText::number(const Row& row, std::size_t column) const {
  std::string text = row.fields[column];
  if (hasDecimalCommas) std::replace(text.begin(), text.end(), ',', '.');
  const auto value = parsed<double>(text);
  if (!value || !std::isfinite(*value)) failField(*this, row, column, "a finite number");
  return *value;
}

int CsvText::integer(const Row& row, std::size_t column) const {
  const auto value = parsed<int>(row.fields[column]);
  if (!value) failField(*this, row, column, "a whole number");
  return *value;
}

CsvText readCsvText(std::string_view text, std::span<const std::string_view> namesWithoutHeader,
                    std::size_t firstLine) {
  text = withoutByteOrderMark(text);
  CsvText csv;
  for (std::size_t number = firstLine; !text.empty(); ++number) {
    const std::string_view line = takeLine(text), content = trimmed(line, " \t\",;");
    if (content.empty()) continue;
    if (content.starts_with('#')) {
      csv.comments.emplace_back(trimmed(content.substr(1)));
      continue;
    }
    const bool isFirst = csv.names.empty();
    if (isFirst && (namesWithoutHeader.empty() || !beginsWithNumber(line))) {
      readNames(csv, line, number);
      continue;
    }
    if (isFirst) setNames(csv, namesWithoutHeader, line);
    addRow(csv, line, number);
  }
  if (csv.names.empty()) throw Error("found no header line with column names");
  findDecimalSign(csv);
  return csv;
}

std::string csvField(std::string_view text) {
  const std::string plain = plainText(text), field = (isSpecial(plain) ? "'" : "") + withApostrophes(plain, ";");
  if (field.find_first_of(",;\"") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csvComment(std::string_view text) { return "# " + withApostrophes(plainText(text), ",;") + "\n"; }

std::string readText(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = FileSource(path).readAll(maxBytes);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string lineText(const CsvText::Row& row) { return "line " + std::to_string(row.line); }

std::string decimalText(double value, int decimals) {
  char digits[400];
  const auto result = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals);
  std::string text(digits, result.ptr);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

namespace {

constexpr double shortestWavelength = 100, longestWavelength = 3000;
constexpr std::size_t minWavelengths = 3;

}  // namespace

Rgb ColourColumns::value(const CsvText& csv, const CsvText::Row& row) const {
  Rgb sum(0);
  for (std::size_t i = 0; i < columns.size(); ++i) sum += csv.number(row, columns[i]) * weights[i];
  for (int channel = 0; channel < 3; ++channel)
    if (!std::isfinite(sum[channel])) throw Error(lineText(row) + ": found values too large for a colour");
  return sum;
}

std::optional<double> wavelengthOf(const std::string& name) {
  std::string text = name;
  std::ranges::replace(text, ',', '.');
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  const std::string_view unit = trimmed({end, std::size_t(text.data() + text.size() - end)}, " ");
  // The micro sign in UTF-8 and Windows-1252, Greek mu.
  if (unit == "um" || unit == "\u00b5m" || unit == "\xb5m" || unit == "\u03bcm")
    value *= 1000;
  else if (!unit.empty() && unit != "nm")
    return std::nullopt;
  if (!(value >= shortestWavelength && value <= longestWavelength)) return std::nullopt;
  return value;
}

ColourColumns wavelengthColumns(const CsvText& csv) {
  std::map<double, std::size_t> byWavelength;
  for (std::size_t column = 0; column < csv.names.size(); ++column)
    if (const auto wavelength = wavelengthOf(csv.names[column]))
      if (!byWavelength.emplace(*wavelength, column).second)
        throw Error("line " + std::to_string(csv.headerLine) + ": found two columns of " + numberText(*wavelength) +
                    " nm, expected one");
  if (byWavelength.size() < minWavelengths) return {};
  if (const auto visible = byWavelength.lower_bound(minVisibleWavelength);
      visible == byWavelength.end() || visible->first > maxVisibleWavelength)
    throw Error("line " + std::to_string(csv.headerLine) + ": found wavelengths from " +
                numberText(byWavelength.begin()->first) + " to " + numberText(byWavelength.rbegin()->first) +
                " nm, expected some that are visible, " + numberText(minVisibleWavelength) + " to " +
                numberText(maxVisibleWavelength) + " nm");
  std::vector<double> wavelengths;
  ColourColumns result;
  for (const auto& [wavelength, column] : byWavelength) {
    wavelengths.push_back(wavelength);
    result.columns.push_back(column);
  }
  result.weights = spectrumWeights(wavelengths);
  return result;
}

ColourColumns rgbColumns(const CsvText& csv) {
  return {{csv.requiredColumn("r"), csv.requiredColumn("g"), csv.requiredColumn("b")},
          {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1)}};
}

}  // namespace gonio::io
