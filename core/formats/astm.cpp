// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/formats/formats.h"
#include "core/formats/point_table.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"

/// Text files similar to ASTM E1392 (Standard Practice for Angle Resolved Optical Scatter Measurements, 1996), such as
/// the reflectance data of Cornell University's Program of Computer Graphics: lines with a key and text, among them
/// NUM_POINTS, up to VARS with the names of the columns; then one line per point, as a CSV table (io::CsvText).
///
///     NUM_POINTS 2
///     VARS theta_i,phi_i,theta_s,phi_s,R,G,B
///     0.5,0,0.5,3.14159,0.31,0.30,0.28
///
/// The columns are those of readPointTable(); without a unit they are AngleUnit::guessed().
namespace gonio::formats {

namespace {

const std::string expectedAstm = "lines NUM_POINTS and VARS (ASTM E1392)";

struct AstmHeader {
  std::optional<io::TextLine> points, variables;
  std::string sample;  ///< what the file says of the sample; may be empty
};

/// Key and text of a line; spreadsheets write them as cells, with empty ones behind.
std::pair<std::string_view, std::string_view> keyOf(std::string_view line) {
  constexpr std::string_view between = " \t,;=:";
  const auto end = std::min(line.find_first_of(between), line.size());
  const auto begin = std::min(line.find_first_not_of(between, end), line.size());
  const auto last = line.find_last_not_of(between);
  return {line.substr(0, end), last == std::string_view::npos ? "" : line.substr(begin, last + 1 - begin)};
}

AstmHeader readAstmHeader(std::string_view text) {
  AstmHeader header;
  io::TextLines lines(text);
  while (const auto line = lines.next()) {
    const auto [key, rest] = keyOf(line->text);
    if (key == "NUM_POINTS") header.points = line;
    if (header.sample.empty() && key.find("SAMPLE") != std::string_view::npos) header.sample = std::string(rest);
    if (key != "VARS") continue;
    header.variables = line;
    break;
  }
  if (!header.points || !header.variables) throw io::FormatMismatch("a text file of another format", expectedAstm);
  return header;
}

std::size_t pointsOf(const AstmHeader& header) {
  const auto count = io::finiteNumber(keyOf(header.points->text).second);
  if (!count || !(*count >= 1 && *count <= 1e9) || *count != std::floor(*count))
    header.points->fail("NUM_POINTS and a whole number, 1 or more");
  return std::size_t(*count);
}

void sniffAstm(const io::ByteSource& source) { readAstmHeader(io::textHead(source, expectedAstm)); }

constexpr std::string_view astmSuffixes[] = {".astm"};

}  // namespace

ScatteredSamples readAstm(const io::ByteSource& source) {
  const std::string text = io::allText(source, maxPointTableBytes);
  const AstmHeader header = readAstmHeader(text);
  const std::string_view names = keyOf(header.variables->text).second;
  const io::CsvText csv = io::readCsvText(std::string_view(text).substr(std::size_t(names.data() - text.data())), {},
                                          header.variables->number);
  if (csv.rows.size() != pointsOf(header))
    header.points->fail("NUM_POINTS " + std::to_string(csv.rows.size()) + ", the number of rows");
  ScatteredSamples samples = readPointTable(csv, DefaultUnit::guessed);
  samples.description = header.sample;
  return samples;
}

constinit const MaterialFormat astmFormat{.name = "ASTM",
                                          .label = "ASTM E1392 samples",
                                          .suffixes = astmSuffixes,
                                          .sniff = sniffAstm,
                                          .read = readScattered<readAstm>};

}  // namespace gonio::formats
