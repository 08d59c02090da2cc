// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/io/byte_source.h"
#include "core/io/csv_text.h"
#include "core/io/text_lines.h"
#include "core/math/colour.h"
#include "core/support/text.h"

/// Text files similar to ASTM E1392 (Standard Practice for Angle Resolved Optical Scatter Measurements, 1996), such as
/// the reflectance data of Cornell University's Program of Computer Graphics: lines with a key and text, among them
/// NUM_POINTS, up to VARS with the names of the columns; then one line per point, values separated by commas.
///
///     NUM_POINTS 2
///     VARS theta_i,phi_i,theta_s,phi_s,R,G,B
///     0.5,0,0.5,3.14159,0.31,0.30,0.28
///
/// Angles: polar angle from the normal and azimuth, of the direction to the light (theta_i, phi_i; phi_i is 0 if
/// missing) and of the scattered light (theta_s, phi_s; also _r, _o, _v). They are radians if none exceeds 2 pi, as at
/// Cornell, else degrees. Values: BRDF in 1/sr, without the cosine: R, G, B (linear sRGB); X, Y, Z (D65 white at Y =
/// 1); three or more wavelengths ("550nm", spectrumWeights()); or one other column, read as grey.
namespace gonio::formats {

namespace {

/// Fields of a table take more memory than their text.
constexpr std::uint64_t maxAstmBytes = 1 << 24;
/// Radians end at a full turn; rounded to a few digits.
constexpr double maxAstmRadians = 2 * pi + 0.01;

const std::string expectedAstm = "lines NUM_POINTS and VARS (ASTM E1392)";

struct AstmHeader {
  std::optional<io::TextLine> points, variables;
  std::string sample;  ///< what the file says of the sample; may be empty
};

/// Key and text of a line.
std::pair<std::string_view, std::string_view> keyOf(std::string_view line) {
  const auto end = std::min(line.find_first_of(" \t"), line.size());
  const auto begin = std::min(line.find_first_not_of(" \t", end), line.size());
  return {line.substr(0, end), line.substr(begin)};
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

std::optional<std::size_t> firstColumn(const io::CsvText& csv, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto column = csv.column(name)) return column;
  return std::nullopt;
}

/// theta_i, phi_i, theta_s, phi_s; phi_i may be missing.
struct AngleColumns {
  std::array<std::optional<std::size_t>, 4> columns;

  explicit AngleColumns(const io::CsvText& csv)
      : columns{csv.requiredColumn("theta_i"), csv.column("phi_i"),
                firstColumn(csv, {"theta_s", "theta_r", "theta_o", "theta_v"}),
                firstColumn(csv, {"phi_s", "phi_r", "phi_o", "phi_v"})} {
    if (!columns[2]) csv.requiredColumn("theta_s");
    if (!columns[3]) csv.requiredColumn("phi_s");
  }
  bool contains(std::size_t column) const { return std::ranges::find(columns, column) != columns.end(); }
  std::array<double, 4> at(const io::CsvText& csv, const io::CsvText::Row& row) const {
    std::array<double, 4> angles{};
    for (std::size_t i = 0; i < 4; ++i)
      if (columns[i]) angles[i] = csv.number(row, *columns[i]);
    return angles;
  }
};

io::ColourColumns colourColumns(const io::CsvText& csv, const AngleColumns& angles) {
  if (csv.column("r") || csv.column("g") || csv.column("b")) return io::rgbColumns(csv);
  if (csv.column("x") && csv.column("y") && csv.column("z"))
    return {{csv.requiredColumn("x"), csv.requiredColumn("y"), csv.requiredColumn("z")},
            {linearSrgb({1, 0, 0}), linearSrgb({0, 1, 0}), linearSrgb({0, 0, 1})}};
  if (io::ColourColumns spectrum = io::wavelengthColumns(csv); !spectrum.empty()) return spectrum;
  for (std::size_t column = 0; column < csv.names.size(); ++column)
    if (!angles.contains(column)) return {{column}, {Rgb(1)}};
  throw Error("line " + std::to_string(csv.headerLine) + ": found no column of values, expected R, G and B");
}

/// The factor by which the file's angles become radians.
double unitOf(const io::CsvText& csv, const AngleColumns& angles) {
  for (const io::CsvText::Row& row : csv.rows)
    for (const double angle : angles.at(csv, row))
      if (std::abs(angle) > maxAstmRadians) return radians(1);
  return 1;
}

void sniffAstm(const io::ByteSource& source) { readAstmHeader(io::textHead(source, expectedAstm)); }

constexpr std::string_view astmSuffixes[] = {".astm"};

}  // namespace

ScatteredSamples readAstm(const io::ByteSource& source) {
  const std::string text = io::allText(source, maxAstmBytes);
  const AstmHeader header = readAstmHeader(text);
  const std::string_view names = keyOf(header.variables->text).second;
  const io::CsvText csv = io::readCsvText(std::string_view(text).substr(std::size_t(names.data() - text.data())), {},
                                          header.variables->number);
  if (csv.rows.size() != pointsOf(header))
    header.points->fail("NUM_POINTS " + std::to_string(csv.rows.size()) + ", the number of rows");
  const AngleColumns angles(csv);
  const io::ColourColumns colours = colourColumns(csv, angles);
  const double unit = unitOf(csv, angles);
  ScatteredSamples samples;
  samples.description = header.sample;
  for (const io::CsvText::Row& row : csv.rows) {
    const auto at = angles.at(csv, row);
    samples.add({fromSpherical(unit * at[0], unit * at[1]), fromSpherical(unit * at[2], unit * at[3])},
                colours.value(csv, row));
  }
  return samples;
}

constinit const MaterialFormat astmFormat{.name = "ASTM",
                                          .label = "ASTM E1392 samples",
                                          .suffixes = astmSuffixes,
                                          .sniff = sniffAstm,
                                          .read = readScattered<readAstm>};

}  // namespace gonio::formats
