// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>

#include "core/formats/formats.h"
#include "core/formats/point_table.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"

/// CSV files of points (io::CsvText) with a line of names, such as those of spreadsheets and of the export target
/// `csv`:
///
///     theta_i,phi_i,theta_o,phi_o,red,green,blue
///     0,0,0,0,0.31,0.30,0.28
///
/// The columns are those of readPointTable(). Angles are in degrees unless the names state radians. Plans and factor
/// readings of an acquisition have similar columns and are not materials.
namespace gonio::formats {

namespace {

const std::string expectedCsv = "a line of names with theta_i, phi_i, theta_o, phi_o (or dphi) and values (CSV)";

/// The names of a text, with no rows. @throws io::FormatMismatch.
io::CsvText csvNames(std::string_view text) {
  io::TextLines lines(text);
  auto line = lines.next();
  while (line && io::withoutComment(line->text).empty()) line = lines.next();
  if (!line) throw io::FormatMismatch("no line of names", expectedCsv);
  try {
    return io::readCsvText(line->text, {}, line->number);
  } catch (const Error&) {
    throw io::FormatMismatch("a first line that is no line of names", expectedCsv);
  }
}

std::string nameList(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  constexpr std::size_t longest = 160;
  return list.size() > longest ? list.substr(0, longest) + "..." : list;
}

/// Whether the rows after the names are numbers: a table, but perhaps of something else.
bool isTable(std::string_view text, const io::CsvText& names) {
  if (names.names.size() < 3 || names.separator == ' ') return false;
  io::TextLines lines(text);
  while (const auto line = lines.next()) {
    if (line->number <= names.headerLine || line->text.starts_with('#')) continue;
    try {
      const io::CsvText row = io::readCsvText(std::string(io::withoutComment(line->text)) + "\n",
                                              std::array<std::string_view, 1>{"1"}, line->number);
      if (row.rows.size() != 1) return false;
      for (std::size_t column = 0; column < row.names.size(); ++column) row.number(row.rows[0], column);
      return row.names.size() == names.names.size();
    } catch (const Error&) {
      return false;
    }
  }
  return false;
}

void sniffCsv(const io::ByteSource& source) {
  const std::string head = io::textHead(source, expectedCsv);
  const io::CsvText names = csvNames(head);
  const auto isNamed = [&](std::string_view name) { return names.column(name).has_value(); };
  if (isNamed("order") || isNamed("curve"))
    throw io::FormatMismatch("a plan or readings of an acquisition", "a measured material");
  if (hasPolarAngles(names)) return;
  // No other format accepts it, since this one is the last: what the file is says more than what each expected.
  if (isTable(head, names))
    throw Error("found a table with the columns " + nameList(names.names) + ", expected " + expectedCsv);
  throw io::FormatMismatch("text without columns of angles", expectedCsv);
}

constexpr std::string_view csvSuffixes[] = {".csv"};

}  // namespace

ScatteredSamples readCsvPoints(const io::ByteSource& source) {
  const io::CsvText csv = io::readCsvText(io::allText(source, maxPointTableBytes));
  if (csv.rows.empty()) throw Error("found no row after the names, expected points");
  return readPointTable(csv, DefaultUnit::degrees);
}

constinit const MaterialFormat csvFormat{.name = "CSV",
                                         .label = "CSV samples",
                                         .suffixes = csvSuffixes,
                                         .isSuffixAmbiguous = true,
                                         .holds = {.nonReciprocal = true, .anisotropic = true},
                                         .sniff = sniffCsv,
                                         .read = readPoints<readCsvPoints>};

}  // namespace gonio::formats
